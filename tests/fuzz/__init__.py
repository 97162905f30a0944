"""A mutation fuzzer: whatever the bytes, there is a result or a diagnostic, and nothing hangs."""
