"""A loaded program as it is called and asked from outside, and with parts exchanged."""
