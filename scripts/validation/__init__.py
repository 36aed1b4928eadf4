"""The pictures of docs/validation.md, each with the sentences of that page that rest on the same runs."""
