package lightning.format.jen;

import java.util.List;
import lightning.base.text.Decimal;

/** Changes the words of one block in the text where an edited element says something else. */
final class BlockPatch {
    private final Source source;
    private final Tokens tokens;
    private final Edits edits;

    BlockPatch(Source source, Tokens tokens, Edits edits) {
        this.source = source;
        this.tokens = tokens;
        this.edits = edits;
    }

    /** Patches the name and the properties; children are the caller's. */
    void apply(Block block, Element wanted) {
        if (!block.name.equals(wanted.name())) {
            replace(block.nameToken, NameText.of(wanted.name()));
        }
        block.type.header().ifPresent(p -> change(block.entry(p.name()), wanted.values().get(p.name())));
        for (Property<?> property : block.type.properties()) {
            Block.Entry entry = block.entry(property.name());
            Value value = wanted.values().get(property.name());
            if (entry == null) {
                if (wanted.mustSay(property)) {
                    insert(block, JenWriter.property(property, value));
                }
            } else if (value instanceof Value.Absent) {
                remove(entry);
            } else {
                property.checkTogether(value);
                change(entry, value);
            }
        }
    }

    /** Replaces only those words of the value that differ. */
    private void change(Block.Entry entry, Value value) {
        if (entry.value() instanceof Value.Numbers(List<Double> before) && value instanceof Value.Numbers(List<Double> after)) {
            for (int i = 0; i < after.size(); i++) {
                if (!before.get(i).equals(after.get(i))) {
                    replace(entry.from() + i, Decimal.text(after.get(i)));
                }
            }
        } else if (!entry.value().equals(value)) {
            replace(entry.from(), value.text());
            remove(entry.from() + 1, entry.to());
        }
    }

    private void replace(int token, String with) {
        edits.replace(tokens.start(token), tokens.end(token), with);
    }

    /** Cuts out a property word by word, so that comments between them stay. */
    private void remove(Block.Entry entry) {
        remove(entry.nameToken(), entry.to());
    }

    private void remove(int from, int to) {
        for (int token = from; token < to; token++) {
            int start = tokens.start(token);
            while (Source.isBlank(source.text().charAt(start - 1))) {
                start--;
            }
            edits.replace(start, tokens.end(token), "");
        }
    }

    /** Puts a property behind the last one in the braces, on a line of its own where that one ends its line. */
    private void insert(Block block, String property) {
        int last = block.entries().stream().mapToInt(e -> e.to() - 1).filter(t -> t > block.open).max()
                .orElse(block.open);
        int end = tokens.end(last);
        int lineEnd = source.lineEnd(end);
        if (tokens.start(last + 1) > lineEnd) {
            String indent = source.indent(end);
            String deeper = last == block.open || startsInLine(block.keyword, end) ? indent + "  " : indent;
            edits.insert(lineEnd, source.newline() + deeper + property);
        } else if (last == block.open) {
            edits.insert(end, " " + property + (tokens.end(last) == tokens.start(last + 1) ? " " : ""));
        } else {
            edits.insert(end, "  " + property);
        }
    }

    private boolean startsInLine(int token, int offset) {
        return tokens.start(token) >= source.lineStart(offset);
    }
}
