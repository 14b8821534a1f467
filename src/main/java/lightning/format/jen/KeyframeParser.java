package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.TokenList.Kind;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.value.SceneLimits;

/** Parser for the keyframes of one animated block. Each method returns the next token to parse. */
final class KeyframeParser {
    private final TokenList tokens;
    private final ProblemList problems;
    private final PropertyParser properties;
    private final Block target;

    /**
     * Creates a parser.
     *
     * @param target block that receives the keyframes
     */
    KeyframeParser(TokenList tokens, ProblemList problems, PropertyParser properties, Block target) {
        this.tokens = tokens;
        this.problems = problems;
        this.properties = properties;
        this.target = target;
        target.keys = new ArrayList<>();
    }

    /** Returns whether values of this property hold until the next keyframe. */
    static boolean isStepped(Property<?> property) {
        return property.form() == Property.Form.WORD || property.isInteger();
    }

    /** Parses properties with their keyframes, starting after the opening brace. */
    int parseBody(int start) {
        int token = start;
        while (kind(token) != Kind.CLOSE) {
            if (kind(token) == Kind.END) {
                return problem(token, token, "expected '}', found " + tokens.describe(token));
            }
            if (kind(token) != Kind.WORD) {
                problem(token, token, "expected a property with keys, found " + tokens.describe(token));
                token = tokens.skipBraces(token);
            } else {
                token = parseProperty(token);
            }
        }
        target.closeToken = token;
        return token + 1;
    }

    private int parseProperty(int nameToken) {
        Optional<Property<?>> property = targetProperties().filter(p -> p.name().equals(tokens.text(nameToken))).findFirst();
        List<String> knownNames = targetProperties().filter(KeyframeParser::canHaveKeys).map(Property::name).toList();
        if (property.isEmpty()) {
            problem(nameToken, nameToken,
                    "unknown property " + Quote.of(tokens.text(nameToken)) + ", expected one of " + String.join(", ", knownNames)
                            + NameSuggestion.hint(tokens.text(nameToken), knownNames));
        } else if (!canHaveKeys(property.get())) {
            problem(nameToken, nameToken, property.get().name() + " has no keys: only numbers and words have");
        } else if (kind(nameToken + 1) != Kind.OPEN) {
            problem(nameToken + 1, nameToken, property.get().name() + ": expected '{' and keys, found " + tokens.describe(nameToken + 1));
        } else {
            return parseKeys(property.get(), nameToken);
        }
        return kind(nameToken + 1) == Kind.OPEN ? tokens.skipBraces(nameToken + 1) : tokens.skipLiterals(nameToken + 1);
    }

    private Stream<Property<?>> targetProperties() {
        return Stream.concat(target.type.header().stream(), target.type.properties().stream());
    }

    private static boolean canHaveKeys(Property<?> property) {
        return property.form() == Property.Form.NUMBERS || property.form() == Property.Form.WORD;
    }

    private int parseKeys(Property<?> property, int nameToken) {
        if (target.keys.stream().anyMatch(k -> k.property() == property)) {
            problem(nameToken, nameToken, property.name() + " must have its keys once, found it again");
        }
        List<Keyframe> keys = new ArrayList<>();
        int token = nameToken + 2;
        while (kind(token) != Kind.CLOSE) {
            int next = parseKey(property, token, keys);
            if (next < 0) {
                return tokens.skipBraces(nameToken + 1);
            }
            token = next;
        }
        if (keys.isEmpty()) {
            problem(token, token, property.name() + ": expected a key such as '24 " + property.initial().text() + "', found '}'");
        }
        target.keys.add(new Block.PropertyKeys(property, nameToken, nameToken + 1, token, keys));
        return token + 1;
    }

    /** Parses one keyframe; returns −1 if there is none. */
    private int parseKey(Property<?> property, int start, List<Keyframe> keys) {
        try {
            int frame = parseFrame(property, start, keys);
            int interpolationToken = start + 1 + property.count();
            Optional<KeyframeValue> setting = parseSetting(property, start + 1);
            boolean hasInterpolation = kind(interpolationToken) == Kind.WORD;
            if (setting.isPresent()) {
                keys.add(new Keyframe(frame, setting.get(),
                        hasInterpolation ? parseInterpolation(property, interpolationToken) : defaultInterpolation(property)));
            }
            return setting.isEmpty() ? -1 : hasInterpolation ? interpolationToken + 1 : interpolationToken;
        } catch (RefusalException e) {
            problem(start, start, e.getMessage());
            return -1;
        }
    }

    private int parseFrame(Property<?> property, int token, List<Keyframe> keys) {
        double frame = kind(token) == Kind.NUMBER ? tokens.number(token) : Double.NaN;
        if (frame != Math.rint(frame)) {
            throw new RefusalException(property.name() + ": expected a frame, a whole number, found " + tokens.describe(token));
        }
        SceneLimits.checkRange(property.name() + ": a frame", frame, 0, Shot.MAX_FRAME);
        if (!keys.isEmpty() && frame <= keys.getLast().frame()) {
            throw new RefusalException(
                    property.name() + ": keys must be in the order of their frames, found " + tokens.describe(token)
                            + " after " + keys.getLast().frame());
        }
        return (int) frame;
    }

    /** Parses the value at {@code start}; empty if it is invalid, which is reported. */
    private Optional<KeyframeValue> parseSetting(Property<?> property, int start) {
        int token = start;
        try {
            if (property.form() == Property.Form.WORD) {
                if (kind(token) != Kind.WORD) {
                    throw new RefusalException(
                            property.name() + " must be " + property.expected() + ", found " + tokens.describe(token));
                }
                property.checkWord(tokens.text(token));
                return Optional.of(new KeyframeValue.Word(tokens.text(token)));
            }
            List<Double> numbers = new ArrayList<>();
            for (; token < start + property.count(); token++) {
                numbers.add(properties.parseNumber(property, token - start, token));
            }
            token = start;
            property.checkValue(new Value.Numbers(numbers));
            return Optional.of(new KeyframeValue.Numbers(numbers));
        } catch (RefusalException e) {
            problem(token, token, e.getMessage());
            return Optional.empty();
        }
    }

    private static Interpolation defaultInterpolation(Property<?> property) {
        return isStepped(property) ? Interpolation.STEPPED : Interpolation.LINEAR;
    }

    private Interpolation parseInterpolation(Property<?> property, int token) {
        for (Interpolation interpolation : Interpolation.values()) {
            if (word(interpolation).equals(tokens.text(token))) {
                if (isStepped(property) && interpolation != Interpolation.STEPPED) {
                    problem(token, token,
                            property.name() + " holds until its next key, expected stepped or nothing, found " + tokens.describe(token));
                }
                return interpolation;
            }
        }
        problem(token, token,
                property.name() + ": expected linear, smooth or stepped, or the frame of the next key, found " + tokens.describe(token));
        return defaultInterpolation(property);
    }

    /** Returns the text of a keyframe's interpolation; empty if it is the default. */
    static String text(Property<?> property, Interpolation interpolation) {
        return interpolation == defaultInterpolation(property) ? "" : " " + word(interpolation);
    }

    private static String word(Interpolation interpolation) {
        return interpolation.name().toLowerCase(Locale.ROOT);
    }

    private Kind kind(int token) {
        return problems.isFull() ? Kind.END : tokens.kind(token);
    }

    private int problem(int token, int nextToken, String message) {
        problems.add(tokens.start(token), target.title() + ": " + message);
        return nextToken;
    }
}
