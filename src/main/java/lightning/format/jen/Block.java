package lightning.format.jen;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.scene.shot.Keyframe;
import org.jspecify.annotations.Nullable;

/** Parsed block with its positions in the text, as token indices; −1 if absent. */
final class Block {
    /**
     * Parsed property.
     *
     * @param nameToken token of the name; −1 for the bare value in a header
     * @param from first token of the value
     * @param to token after the last one of the value
     * @param value parsed value
     */
    record Entry(Property<?> property, int nameToken, int from, int to, Value value) {}

    /**
     * Parsed keyframes of a property.
     *
     * @param openToken token of the opening brace
     * @param closeToken token of the closing brace
     * @param keys the valid keyframes
     */
    record PropertyKeys(Property<?> property, int nameToken, int openToken, int closeToken, List<Keyframe> keys) {}

    private static final int INITIAL_CAPACITY = 3;

    final BlockType<?> type;
    final int keywordToken;
    int nameToken = -1;
    String name = "";
    int openToken = -1;
    int closeToken = -1;
    /** Children of a group, animated blocks of a shot, or blocks that are properties of a picture. */
    final List<Block> children;
    /** Keyframes of an animated block. */
    List<PropertyKeys> keys = List.of();
    /** All properties in the text, valid or not. Lists, since there are few properties but up to a million blocks. */
    private final List<Property<?>> writtenProperties = new ArrayList<>(INITIAL_CAPACITY);
    /** Valid properties, in text order. */
    private final List<Entry> entries = new ArrayList<>(INITIAL_CAPACITY);

    Block(BlockType<?> type, int keywordToken) {
        this.type = type;
        this.keywordToken = keywordToken;
        children = type == BlockTypes.GROUP || type == BlockTypes.SHOT || type == BlockTypes.PICTURE ? new ArrayList<>() : List.of();
    }

    /** Records that a property is present; returns true the first time. */
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

    /** Adds a valid property, unless it is already present. */
    void add(Entry entry) {
        if (entry(entry.property().name()) == null) {
            entries.add(entry);
        }
    }

    /** Returns a valid property, or null if absent. */
    @Nullable
    Entry entry(String property) {
        for (Entry e : entries) {
            if (e.property().name().equals(property)) {
                return e;
            }
        }
        return null;
    }

    /** Returns the value or default of a property, or null if it has neither. */
    @Nullable
    Value value(String property) {
        Entry entry = entry(property);
        return entry == null ? type.initials().get(property) : entry.value();
    }

    /** Returns all values, written or default, without children. */
    BlockContent content() {
        Map<String, Value> values = new LinkedHashMap<>();
        type.properties().forEach(p -> values.put(p.name(), value(p.name())));
        return new BlockContent(type, name, values, List.of());
    }

    /** Returns the valid properties, in text order. */
    List<Entry> entries() {
        return Collections.unmodifiableList(entries);
    }

    /** Returns the name for messages: {@code light 'key'} or {@code camera}. */
    String title() {
        return name.isEmpty() ? type.keyword() : type.keyword() + " " + Quote.of(name);
    }

    /** Returns the token that represents the whole block in messages. */
    int problemToken() {
        return nameToken >= 0 ? nameToken : keywordToken;
    }
}
