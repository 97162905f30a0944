"""Where the data of a running program lies, and how it is reached from outside."""
