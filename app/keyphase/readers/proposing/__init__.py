"""What an unknown table probably is, with the evidence for each guess; nothing of it counts alone.

A proposal is for a person to confirm: `keyphase inspect` prints it as a recipe, the page shows it
column by column.
"""
