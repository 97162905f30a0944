"""How good the tests of a program are, and what can be said of it without them."""
