"""What is known before a program runs, and the Python that can be left out for it."""
