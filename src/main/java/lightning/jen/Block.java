package lightning.jen;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.text.Quote;

/** A block as it stands in the text. All places are numbers of tokens; −1 where something is missing. */
final class Block {
    /**
     * A written property.
     *
     * @param nameToken −1 for the value in a header
     * @param from      the first token of the value
     * @param to        behind the last token of the value
     * @param value     what was read
     */
    record Entry(Property<?> property, int nameToken, int from, int to, Value value) {}

    final BlockType<?> type;
    final int keyword;
    int nameToken = -1;
    String name = "";
    int open = -1;
    int close = -1;
    /** The names of all properties that are written, well or not. */
    final Set<String> written = new HashSet<>();
    /** The well written ones by property name, in the order of the text. */
    final Map<String, Entry> entries = new LinkedHashMap<>();
    /** What a group holds. */
    final List<Block> children = new ArrayList<>();

    Block(BlockType<?> type, int keyword) {
        this.type = type;
        this.keyword = keyword;
    }

    /** How messages call it: {@code light 'key'} or {@code camera}. */
    String title() {
        return name.isEmpty() ? type.keyword() : type.keyword() + " " + Quote.of(name);
    }

    /** The token that stands for the whole block in messages. */
    int place() {
        return nameToken >= 0 ? nameToken : keyword;
    }
}
