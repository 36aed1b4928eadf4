"""What a release consists of, made on one machine; nothing is published."""
