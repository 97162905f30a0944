"""Templates to text: Jinja renders canonical SCL, which is parsed, checked, lowered and printed."""
