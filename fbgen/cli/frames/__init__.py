"""Frames and cyclic data as people read and write them: for decode, encode, talk, record."""
