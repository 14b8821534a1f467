package lightning.format.jen;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lightning.base.text.Quote;
import lightning.scene.shot.Key;

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

    /**
     * What is written of one property's keys.
     *
     * @param open  the token of the brace before them; {@code close} of the one behind
     * @param keys  those that are well written
     */
    record Keys(Property<?> property, int nameToken, int open, int close, List<Key> keys) {}

    private static final int FEW = 3;

    final BlockType<?> type;
    final int keyword;
    int nameToken = -1;
    String name = "";
    int open = -1;
    int close = -1;
    /** What a group holds, or what has keys in a shot. */
    final List<Block> children;
    /** Of what has keys in a shot. */
    List<Keys> keys = List.of();
    /** All properties that are written, well or not. Lists, as there are few of them and may be a million blocks. */
    private final List<Property<?>> written = new ArrayList<>(FEW);
    /** The well written ones, in the order of the text. */
    private final List<Entry> entries = new ArrayList<>(FEW);

    Block(BlockType<?> type, int keyword) {
        this.type = type;
        this.keyword = keyword;
        children = type == Blocks.GROUP || type == Blocks.SHOT ? new ArrayList<>() : List.of();
    }

    /** Tells that a property is written; whether it was not before. */
    boolean write(Property<?> property) {
        return !isWritten(property.name()) && written.add(property);
    }

    boolean isWritten(String property) {
        for (Property<?> p : written) {
            if (p.name().equals(property)) {
                return true;
            }
        }
        return false;
    }

    /** Adds a well written property, unless it has been before. */
    void add(Entry entry) {
        if (entry(entry.property().name()) == null) {
            entries.add(entry);
        }
    }

    /** A well written property; null where there is none of that name. */
    Entry entry(String property) {
        for (Entry e : entries) {
            if (e.property().name().equals(property)) {
                return e;
            }
        }
        return null;
    }

    /** What a property is, well written or by default; null where it is neither. */
    Value value(String property) {
        Entry entry = entry(property);
        return entry == null ? type.initials().get(property) : entry.value();
    }

    /** The well written properties, in the order of the text. */
    List<Entry> entries() {
        return Collections.unmodifiableList(entries);
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
