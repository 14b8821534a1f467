package lightning.format.jen;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import lightning.base.text.Quote;
import lightning.scene.shot.Keyframe;

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
     * @param openToken  the token of the brace before them; {@code closeToken} of the one behind
     * @param keys  those that are well written
     */
    record PropertyKeys(Property<?> property, int nameToken, int openToken, int closeToken, List<Keyframe> keys) {}

    private static final int INITIAL_CAPACITY = 3;

    final BlockType<?> type;
    final int keywordToken;
    int nameToken = -1;
    String name = "";
    int openToken = -1;
    int closeToken = -1;
    /** What a group holds, or what has keys in a shot. */
    final List<Block> children;
    /** Of what has keys in a shot. */
    List<PropertyKeys> keys = List.of();
    /** All properties that are written, well or not. Lists, as there are few of them and may be a million blocks. */
    private final List<Property<?>> writtenProperties = new ArrayList<>(INITIAL_CAPACITY);
    /** The well written ones, in the order of the text. */
    private final List<Entry> entries = new ArrayList<>(INITIAL_CAPACITY);

    Block(BlockType<?> type, int keywordToken) {
        this.type = type;
        this.keywordToken = keywordToken;
        children = type == BlockTypes.GROUP || type == BlockTypes.SHOT ? new ArrayList<>() : List.of();
    }

    /** Tells that a property is written; whether it was not before. */
    boolean markWritten(Property<?> property) {
        return !isWritten(property.name()) && writtenProperties.add(property);
    }

    boolean isWritten(String property) {
        for (Property<?> p : writtenProperties) {
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
    int problemToken() {
        return nameToken >= 0 ? nameToken : keywordToken;
    }
}
