"""Desks: recordings at work, each with its document, its worker and its revisions."""
