package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.format.jen.Tokens.Kind;
import lightning.scene.Limits;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;

/** Reads the keys of one thing in a shot. Each method returns the token to go on at. */
final class KeyParser {
    private final Tokens tokens;
    private final Problems problems;
    private final PropertyParser properties;
    private final Block target;

    /** @param target where the keys come to */
    KeyParser(Tokens tokens, Problems problems, PropertyParser properties, Block target) {
        this.tokens = tokens;
        this.problems = problems;
        this.properties = properties;
        this.target = target;
        target.keys = new ArrayList<>();
    }

    /** Whether values of this property stay until the next key. */
    static boolean holds(Property<?> property) {
        return property.form() == Property.Form.WORD || property.whole();
    }

    /** Reads properties with their keys from behind the brace that opens the thing. */
    int body(int from) {
        int at = from;
        while (kind(at) != Kind.CLOSE) {
            if (kind(at) == Kind.END) {
                return problem(at, at, "expected '}', found " + tokens.found(at));
            }
            if (kind(at) != Kind.WORD) {
                problem(at, at, "expected a property with keys, found " + tokens.found(at));
                at = behind(at);
            } else {
                at = property(at);
            }
        }
        target.close = at;
        return at + 1;
    }

    private int property(int name) {
        Optional<Property<?>> found = all().filter(p -> p.name().equals(tokens.text(name))).findFirst();
        List<String> known = all().filter(KeyParser::hasKeys).map(Property::name).toList();
        if (found.isEmpty()) {
            problem(name, name, "unknown property " + Quote.of(tokens.text(name)) + ", expected one of " + String.join(", ", known)
                    + Nearest.hint(tokens.text(name), known));
        } else if (!hasKeys(found.get())) {
            problem(name, name, found.get().name() + " has no keys: only numbers and words have");
        } else if (kind(name + 1) != Kind.OPEN) {
            problem(name + 1, name, found.get().name() + ": expected '{' and keys, found " + tokens.found(name + 1));
        } else {
            return keys(found.get(), name);
        }
        return kind(name + 1) == Kind.OPEN ? behind(name + 1) : behindLiterals(name + 1);
    }

    private Stream<Property<?>> all() {
        return Stream.concat(target.type.header().stream(), target.type.properties().stream());
    }

    private static boolean hasKeys(Property<?> property) {
        return property.form() == Property.Form.NUMBERS || property.form() == Property.Form.WORD;
    }

    private int keys(Property<?> property, int name) {
        if (target.keys.stream().anyMatch(k -> k.property() == property)) {
            problem(name, name, property.name() + " must have its keys once, found it again");
        }
        List<Key> keys = new ArrayList<>();
        int at = name + 2;
        while (kind(at) != Kind.CLOSE) {
            int next = key(property, at, keys);
            if (next < 0) {
                return behind(name + 1);
            }
            at = next;
        }
        if (keys.isEmpty()) {
            problem(at, at, property.name() + ": expected a key, as in '24 " + property.initial().text() + "', found '}'");
        }
        target.keys.add(new Block.Keys(property, name, name + 1, at, keys));
        return at + 1;
    }

    /** Reads one key; −1 where there is none. */
    private int key(Property<?> property, int from, List<Key> keys) {
        try {
            int frame = frame(property, from, keys);
            int passage = from + 1 + property.count();
            Optional<Setting> setting = setting(property, from + 1);
            boolean told = kind(passage) == Kind.WORD;
            if (setting.isPresent()) {
                keys.add(new Key(frame, setting.get(), told ? passage(property, passage) : initial(property)));
            }
            return setting.isEmpty() ? -1 : told ? passage + 1 : passage;
        } catch (IllegalArgumentException e) {
            problem(from, from, e.getMessage());
            return -1;
        }
    }

    private int frame(Property<?> property, int at, List<Key> keys) {
        double frame = kind(at) == Kind.NUMBER ? tokens.number(at) : Double.NaN;
        if (frame != Math.rint(frame)) {
            throw new IllegalArgumentException(property.name() + ": expected a frame, a whole number, found " + tokens.found(at));
        }
        Limits.range(property.name() + ": a frame", frame, 0, Shot.MAX_FRAME);
        if (!keys.isEmpty() && frame <= keys.getLast().frame()) {
            throw new IllegalArgumentException(property.name() + ": keys must be in the order of their frames, found " + tokens.found(at)
                    + " behind " + keys.getLast().frame());
        }
        return (int) frame;
    }

    /** The value from {@code from} on; nothing where it is told to be wrong. */
    private Optional<Setting> setting(Property<?> property, int from) {
        int at = from;
        try {
            if (property.form() == Property.Form.WORD) {
                if (kind(at) != Kind.WORD) {
                    throw new IllegalArgumentException(property.name() + " must be " + property.expected() + ", found " + tokens.found(at));
                }
                property.checkWord(tokens.text(at));
                return Optional.of(new Setting.Word(tokens.text(at)));
            }
            List<Double> numbers = new ArrayList<>();
            for (; at < from + property.count(); at++) {
                numbers.add(properties.number(property, at - from, at));
            }
            at = from;
            property.checkTogether(new Value.Numbers(numbers));
            return Optional.of(new Setting.Numbers(numbers));
        } catch (IllegalArgumentException e) {
            problem(at, at, e.getMessage());
            return Optional.empty();
        }
    }

    private static Passage initial(Property<?> property) {
        return holds(property) ? Passage.STEPPED : Passage.LINEAR;
    }

    private Passage passage(Property<?> property, int at) {
        for (Passage passage : Passage.values()) {
            if (word(passage).equals(tokens.text(at))) {
                if (holds(property) && passage != Passage.STEPPED) {
                    problem(at, at, property.name() + " stays until its next key, expected stepped or nothing, found " + tokens.found(at));
                }
                return passage;
            }
        }
        problem(at, at, property.name() + ": expected linear, smooth or stepped, or the frame of the next key, found " + tokens.found(at));
        return initial(property);
    }

    /** How a file says how a key goes on; empty where it need not. */
    static String text(Property<?> property, Passage passage) {
        return passage == initial(property) ? "" : " " + word(passage);
    }

    private static String word(Passage passage) {
        return passage.name().toLowerCase(Locale.ROOT);
    }

    /** Behind the braces that open here, or behind the token. */
    private int behind(int from) {
        int depth = 0;
        int at = from;
        do {
            if (kind(at) == Kind.END) {
                return at;
            }
            depth += kind(at) == Kind.OPEN ? 1 : kind(at) == Kind.CLOSE ? -1 : 0;
            at++;
        } while (depth > 0);
        return at;
    }

    /** At the next word or brace. */
    private int behindLiterals(int from) {
        int at = from;
        while (kind(at) == Kind.NUMBER || kind(at) == Kind.BAD_NUMBER || kind(at) == Kind.STRING) {
            at++;
        }
        return at;
    }

    private Kind kind(int at) {
        return problems.isFull() ? Kind.END : tokens.kind(at);
    }

    private int problem(int token, int goOn, String message) {
        problems.add(tokens.start(token), target.title() + ": " + message);
        return goOn;
    }
}
