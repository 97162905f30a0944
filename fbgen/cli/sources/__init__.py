"""PLC sources that commands are given: which files, as which programs, with what beside them."""
