"""What was worked out once is kept on disk for the next process.

It is kept only under a key that is a hash of everything that it was made from. Nobody notices but
by the time that it saves: what cannot be read or written, or is damaged, is worked out anew.
"""

from fbgen.cache.entries import keep, kept
from fbgen.cache.folder import cache_folder
from fbgen.cache.keys import key_of
from fbgen.cache.remembering import remembered

__all__ = ["cache_folder", "keep", "kept", "key_of", "remembered"]
