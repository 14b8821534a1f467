package lightning.format.jen;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Set;
import lightning.base.text.DecimalNumber;

/** Minimal text edits that update one block to changed content. */
record BlockPatch(SourceText source, TokenList tokens, TextEdits edits, Set<LeftOutFile> leftOut) {
    /** Patches the name and the properties; children are patched by the caller. */
    void apply(Block block, BlockContent target) {
        if (!block.name.equals(target.name())) {
            replace(block.nameToken, NameSyntax.format(target.name()));
        }
        block.type.header().ifPresent(p -> change(requireNonNull(block.entry(p.name())), target.value(p)));
        for (Property<?> property : block.type.properties()) {
            Block.Entry entry = block.entry(property.name());
            Value value = target.value(property);
            if (entry == null) {
                if (target.mustWrite(property)) {
                    insert(block, JenWriter.property(property, value));
                }
            } else if (value instanceof Value.Nested(BlockContent content)) {
                apply(nested(block, entry), content);
            } else if (value instanceof Value.Absent) {
                if (!isLeftOut(block, entry)) {
                    remove(entry);
                }
            } else {
                property.checkValue(value);
                change(entry, value);
            }
        }
    }

    /** Returns whether a property names a file that the scene lacks, or depends on such a file. */
    private boolean isLeftOut(Block block, Block.Entry entry) {
        Block.Entry file =
                TextureProperty.of(block.type).stream().filter(t -> t.dependents().contains(entry.property().name()))
                        .findFirst().map(t -> block.entry(t.name())).orElse(entry);
        return file.value() instanceof Value.Quoted(String name) && leftOut.contains(new LeftOutFile(file.property().name(), name));
    }

    /** Replaces only the tokens of the value that differ. */
    private void change(Block.Entry entry, Value value) {
        if (entry.value() instanceof Value.Numbers(List<Double> before) && value instanceof Value.Numbers(List<Double> after)) {
            for (int i = 0; i < after.size(); i++) {
                if (!before.get(i).equals(after.get(i))) {
                    replace(entry.from() + i, DecimalNumber.format(after.get(i)));
                }
            }
        } else if (!entry.value().equals(value)) {
            replace(entry.from(), value.text());
            remove(entry.from() + 1, entry.to());
        }
    }

    private void replace(int token, String replacement) {
        edits.replace(tokens.start(token), tokens.end(token), replacement);
    }

    private static Block nested(Block block, Block.Entry entry) {
        return block.children.stream().filter(c -> c.keywordToken == entry.nameToken()).findFirst().orElseThrow();
    }

    /** Removes a property token by token, so that comments between them remain; a block with the comments inside. */
    private void remove(Block.Entry entry) {
        if (entry.value() instanceof Value.Nested) {
            removeBlock(tokens.start(entry.nameToken()), tokens.end(entry.to() - 1));
        } else {
            remove(entry.nameToken(), entry.to());
        }
    }

    /** Removes a range of the text, with its lines if they contain nothing else. */
    private void removeBlock(int start, int end) {
        String text = source.text();
        int lineStart = source.lineStart(start);
        int lineEnd = source.lineEnd(end);
        if (text.substring(lineStart, start).isBlank() && text.substring(end, lineEnd).isBlank()) {
            // Keeps the line end after it, where another edit may insert a property.
            int previousEnd = lineStart - (text.startsWith("\r\n", lineStart - 2) ? 2 : 1);
            edits.replace(previousEnd, lineEnd, "");
            return;
        }
        int blank = start;
        while (SourceText.isBlank(text.charAt(blank - 1))) {
            blank--;
        }
        boolean touchesNext = end < lineEnd && !SourceText.isBlank(text.charAt(end)) && text.charAt(end) != '}';
        edits.replace(blank, end, touchesNext ? " " : "");
    }

    private void remove(int from, int to) {
        for (int token = from; token < to; token++) {
            int start = tokens.start(token);
            while (SourceText.isBlank(source.text().charAt(start - 1))) {
                start--;
            }
            edits.replace(start, tokens.end(token), "");
        }
    }

    /** Inserts a property after the last one in the braces, on a line of its own if that one ends its line. */
    private void insert(Block block, String property) {
        int last = block.entries().stream().mapToInt(e -> e.to() - 1).filter(t -> t > block.openToken).max()
                .orElse(block.openToken);
        int end = tokens.end(last);
        int lineEnd = source.lineEnd(end);
        if (tokens.start(last + 1) > lineEnd) {
            String indent = source.indent(end);
            String deeperIndent = last == block.openToken || startsInLine(block.keywordToken, end) ? indent + "  " : indent;
            edits.insert(lineEnd, source.newline() + deeperIndent + property);
        } else if (last == block.openToken) {
            edits.insert(end, " " + property + (tokens.end(last) == tokens.start(last + 1) ? " " : ""));
        } else {
            edits.insert(end, "  " + property);
        }
    }

    private boolean startsInLine(int token, int offset) {
        return tokens.start(token) >= source.lineStart(offset);
    }
}
