package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.format.jen.Tokens.Kind;
import lightning.scene.Limits;
import lightning.scene.Links;

/** Reads one property with its value and checks it. Each method returns the token to go on at. */
final class PropertyParser {
    private static final Set<String> NO_NUMBERS = Set.of("nan", "inf", "infinity");

    private final Tokens tokens;
    private final Problems problems;
    /** The names found so far: a million shapes share those of a few materials. */
    private final Map<String, Value.Name> names = new HashMap<>();

    PropertyParser(Tokens tokens, Problems problems) {
        this.tokens = tokens;
        this.problems = problems;
    }

    /** Reads the bare value of {@code property} behind a block's name. */
    int header(Block block, Property<?> property, int at) {
        return tokens.kind(at) == Kind.OPEN
                ? problem(at, at, block.title() + ": expected " + property.expected() + ", found '{'")
                : value(block, property, -1, at);
    }

    /** Reads the property whose name is the word at {@code at}. */
    int property(Block block, int at) {
        String name = tokens.text(at);
        Property<?> property = block.type.property(name).orElse(null);
        if (property == null) {
            String hint = Nearest.hint(name, block.type.propertyNames());
            problem(at, at, block.title() + ": unknown property " + Quote.of(name)
                    + (hint.isEmpty() ? ", expected one of " + String.join(", ", block.type.propertyNames()) : hint));
            return skipValue(block, at + 1);
        }
        if (!block.write(property)) {
            problem(at, at, block.title() + ": " + name + " must be written once, found it again");
        }
        return value(block, property, at, at + 1);
    }

    private int value(Block block, Property<?> property, int nameToken, int at) {
        return switch (property.form()) {
            case NUMBERS -> numbers(block, property, nameToken, at);
            case WORD -> single(block, property, tokens.kind(at) == Kind.WORD, nameToken, at);
            case NAME -> single(block, property, tokens.isName(at), nameToken, at);
            case QUOTED -> single(block, property, tokens.kind(at) == Kind.STRING, nameToken, at);
            case LINKS -> links(block, property, nameToken, at);
        };
    }

    /** A word, and behind two of the words names in quotes, as many as there are. */
    private int links(Block block, Property<?> property, int nameToken, int from) {
        if (tokens.kind(from) != Kind.WORD || !property.choices().contains(tokens.text(from))) {
            return single(block, property, false, nameToken, from);
        }
        String word = tokens.text(from);
        boolean named = word.equals(Value.ONLY) || word.equals(Value.EXCEPT);
        List<String> all = new ArrayList<>();
        int at = from + 1;
        for (; named && tokens.kind(at) == Kind.STRING; at++) {
            if (all.contains(tokens.text(at)) || all.size() == Limits.MAX_LINKS) {
                problem(at, at, block.title() + ": " + property.name() + (all.size() == Limits.MAX_LINKS
                        ? " may name at most " + Limits.MAX_LINKS + " shapes and groups, found more"
                        : " must name each shape once, found " + tokens.found(at) + " again"));
                return skipValue(block, at);
            }
            all.add(tokens.text(at));
        }
        if (named && all.isEmpty()) {
            problem(at, at,
                    block.title() + ": " + property.name() + ": expected names of shapes or groups in quotes behind " + word + ", found "
                            + tokens.found(at));
            return at;
        }
        try {
            boolean only = word.equals(Value.ONLY) || word.equals(Value.NONE);
            block.add(new Block.Entry(property, nameToken, from, at, new Value.Linked(new Links(only, all))));
        } catch (IllegalArgumentException e) {
            problem(from, from, block.title() + ": " + e.getMessage());
        }
        return at;
    }

    private int single(Block block, Property<?> property, boolean right, int nameToken, int at) {
        if (!right) {
            String where = nameToken < 0 ? "" : property.name() + ": ";
            problem(at, at, block.title() + ": " + where + "expected " + property.expected() + ", found " + tokens.found(at));
            return isValue(tokens.kind(at)) ? at + 1 : at;
        }
        try {
            Value value = value(property, tokens.text(at));
            property.checkTogether(value);
            block.add(new Block.Entry(property, nameToken, at, at + 1, value));
        } catch (IllegalArgumentException e) {
            problem(at, at, block.title() + ": " + e.getMessage());
        }
        return at + 1;
    }

    private Value value(Property<?> property, String text) {
        return switch (property.form()) {
            case WORD -> {
                property.checkWord(text);
                yield new Value.Word(text);
            }
            case NAME -> names.computeIfAbsent(text, Value.Name::new);
            case QUOTED -> new Value.Quoted(text);
            case NUMBERS, LINKS -> throw new IllegalStateException(property.name() + " is no single word");
        };
    }

    private int numbers(Block block, Property<?> property, int nameToken, int from) {
        List<Double> numbers = new ArrayList<>(property.count());
        int at = from;
        while (isNumber(block, at, at - from < property.count())) {
            if (at - from < property.count()) {
                try {
                    numbers.add(number(property, at - from, at));
                } catch (IllegalArgumentException e) {
                    problem(at, at, block.title() + ": " + e.getMessage());
                }
            }
            at++;
        }
        if (at - from != property.count()) {
            problem(nameToken, nameToken, block.title() + ": " + property.name() + " must have " + property.expected()
                    + ", found " + (at - from));
        } else if (numbers.size() == property.count()) {
            together(block, new Block.Entry(property, nameToken, from, at, new Value.Numbers(numbers)));
        }
        return at;
    }

    private void together(Block block, Block.Entry entry) {
        try {
            entry.property().checkTogether(entry.value());
            block.add(entry);
        } catch (IllegalArgumentException e) {
            problem(entry.from(), entry.from(), block.title() + ": " + e.getMessage());
        }
    }

    /** @throws IllegalArgumentException if the token is no number that the property may have at {@code index} */
    double number(Property<?> property, int index, int token) {
        if (tokens.kind(token) != Kind.NUMBER) {
            throw new IllegalArgumentException(property.name() + " must be " + property.expected() + ", found "
                    + tokens.found(token));
        }
        double number = tokens.number(token);
        if (Double.isInfinite(number)) {
            throw new IllegalArgumentException(property.name() + " must be a number within ±1.8e308, found "
                    + tokens.found(token));
        }
        property.checkNumber(index, number);
        return number;
    }

    /**
     * Whether a number stands here, or a string or word where a number should be, rather than the
     * next property or block.
     */
    private boolean isNumber(Block block, int at, boolean missing) {
        if (tokens.kind(at) != Kind.WORD) {
            return isValue(tokens.kind(at));
        }
        String word = tokens.text(at);
        return NO_NUMBERS.contains(word.toLowerCase(Locale.ROOT))
                || missing && isNoKeyword(block, word) && Nearest.to(word, block.type.propertyNames()).isEmpty();
    }

    private static boolean isNoKeyword(Block block, String word) {
        return block.type.property(word).isEmpty() && Blocks.of(word).isEmpty();
    }

    private int skipValue(Block block, int from) {
        int at = from;
        while (isValue(tokens.kind(at)) || tokens.kind(at) == Kind.WORD && isNoKeyword(block, tokens.text(at))) {
            at++;
        }
        return at;
    }

    private static boolean isValue(Kind kind) {
        return kind == Kind.NUMBER || kind == Kind.BAD_NUMBER || kind == Kind.STRING;
    }

    private int problem(int token, int goOn, String message) {
        problems.add(tokens.start(token), message);
        return goOn;
    }
}
