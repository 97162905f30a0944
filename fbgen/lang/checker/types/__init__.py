"""Types and values: literals, constants, conversions, and the types that come with a controller."""
