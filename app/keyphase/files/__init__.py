"""Writing a file whole, reading one within limits, and what ships with keyphase."""
