"""The PLC language: `parser` makes an AST of text, `checker` a program of it, `printer` text."""
