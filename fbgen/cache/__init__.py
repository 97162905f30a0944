"""What was worked out once is kept on disk for the next process.

Only data is kept, never code, and only under a key that is a hash of everything that it was made
from. Nobody notices but by the time that it saves: what cannot be read or written, or is damaged,
is worked out anew.
"""

from fbgen.cache.entries import keep, kept
from fbgen.cache.keys import key_of

__all__ = ["keep", "kept", "key_of"]
