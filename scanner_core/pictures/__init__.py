"""Pictures of surfaces that need neither a display nor OpenGL."""
