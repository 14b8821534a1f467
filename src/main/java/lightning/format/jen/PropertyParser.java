package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.TokenList.Kind;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/** Parser for one property with its value. Each method returns the next token to parse. */
final class PropertyParser {
    private static final Set<String> NON_FINITE_WORDS = Set.of("nan", "inf", "infinity");

    private final TokenList tokens;
    private final ProblemList problems;
    /** Interned names: a million shapes share the names of a few materials. */
    private final Map<String, Value.Name> names = new HashMap<>();

    PropertyParser(TokenList tokens, ProblemList problems) {
        this.tokens = tokens;
        this.problems = problems;
    }

    /** Parses the bare value of {@code property} after a block's name. */
    int parseHeader(Block block, Property<?> property, int token) {
        return tokens.kind(token) == Kind.OPEN
                ? problem(token, token, block.title() + ": expected " + property.expected() + ", found '{'")
                : parseValue(block, property, -1, token);
    }

    /** Parses the property whose name is at {@code token}. */
    int parseProperty(Block block, int token) {
        String name = tokens.text(token);
        Property<?> property = block.type.property(name).orElse(null);
        if (property == null) {
            String hint = NameSuggestion.hint(name, block.type.propertyNames());
            problem(token, token, block.title() + ": unknown property " + Quote.of(name)
                    + (hint.isEmpty() ? ", expected one of " + NameSuggestion.list(block.type.propertyNames()) : hint));
            return skipValue(block, token + 1);
        }
        if (!block.markWritten(property)) {
            problem(token, token, block.title() + ": " + name + " must be written once, found it again");
        }
        return parseValue(block, property, token, token + 1);
    }

    private int parseValue(Block block, Property<?> property, int nameToken, int token) {
        return switch (property.form()) {
            case NUMBERS -> parseNumbers(block, property, nameToken, token);
            case WORD -> parseSingle(block, property, tokens.kind(token) == Kind.WORD, nameToken, token);
            case NAME -> parseSingle(block, property, tokens.isName(token), nameToken, token);
            case QUOTED -> parseSingle(block, property, tokens.kind(token) == Kind.STRING, nameToken, token);
            case LINKS -> parseLinks(block, property, nameToken, token);
            case GAINS -> parseGains(block, property, nameToken, token);
            case BLOCK -> parseBlock(block, property, nameToken, token);
        };
    }

    /** Parses light links: a word, followed for two of the words by quoted names. */
    private int parseLinks(Block block, Property<?> property, int nameToken, int start) {
        if (tokens.kind(start) != Kind.WORD || !property.choices().contains(tokens.text(start))) {
            return parseSingle(block, property, false, nameToken, start);
        }
        String word = tokens.text(start);
        boolean hasNames = word.equals(Value.ONLY) || word.equals(Value.EXCEPT);
        List<String> linkNames = new ArrayList<>();
        int token = start + 1;
        for (; hasNames && tokens.kind(token) == Kind.STRING; token++) {
            if (linkNames.contains(tokens.text(token)) || linkNames.size() == SceneLimits.MAX_LINKS) {
                problem(token, token, block.title() + ": " + property.name() + (linkNames.size() == SceneLimits.MAX_LINKS
                        ? " may name at most " + SceneLimits.MAX_LINKS + " shapes and groups, found more"
                        : " must name each shape once, found " + tokens.describe(token) + " again"));
                return skipValue(block, token);
            }
            linkNames.add(tokens.text(token));
        }
        if (hasNames && linkNames.isEmpty()) {
            problem(token, token,
                    block.title() + ": " + property.name() + ": expected names of shapes or groups in quotes after " + word + ", found "
                            + tokens.describe(token));
            return token;
        }
        try {
            boolean isOnly = word.equals(Value.ONLY) || word.equals(Value.NONE);
            block.add(new Block.Entry(property, nameToken, start, token, new Value.LinkSet(new ShapeLinks(isOnly, linkNames))));
        } catch (RefusalException e) {
            problem(start, start, block.title() + ": " + e.getMessage());
        }
        return token;
    }

    /** Parses gains: quoted names, each followed by a number. */
    private int parseGains(Block block, Property<?> property, int nameToken, int start) {
        List<ShapeGains.Entry> gains = new ArrayList<>();
        int token = start;
        for (; tokens.kind(token) == Kind.STRING; token += 2) {
            if (tokens.kind(token + 1) != Kind.NUMBER) {
                return problem(token + 1, skipValue(block, token + 1), block.title() + ": " + property.name() + ": expected a number after "
                        + tokens.describe(token) + ", found " + tokens.describe(token + 1));
            }
            String name = tokens.text(token);
            if (gains.stream().anyMatch(e -> e.name().equals(name)) || gains.size() == SceneLimits.MAX_LINKS) {
                return problem(token, skipValue(block, token), block.title() + ": " + property.name()
                        + (gains.size() == SceneLimits.MAX_LINKS
                                ? " may name at most " + SceneLimits.MAX_LINKS + " shapes and groups, found more"
                                : " must name each shape once, found " + tokens.describe(token) + " again"));
            }
            try {
                gains.add(new ShapeGains.Entry(name, parseNumber(property, 0, token + 1)));
            } catch (RefusalException e) {
                return problem(token, skipValue(block, token), block.title() + ": " + e.getMessage());
            }
        }
        if (gains.isEmpty()) {
            return parseSingle(block, property, false, nameToken, start);
        }
        block.add(new Block.Entry(property, nameToken, start, token, new Value.Gains(new ShapeGains(gains))));
        return token;
    }

    /** Parses properties in braces. */
    private int parseBlock(Block block, Property<?> property, int nameToken, int openToken) {
        if (tokens.kind(openToken) != Kind.OPEN) {
            return problem(openToken, skipValue(block, openToken), block.title() + ": " + property.name() + ": expected "
                    + property.expected() + ", found " + tokens.describe(openToken));
        }
        var nested = new Block(BlockTypes.nested(property), nameToken);
        nested.openToken = openToken;
        int end = parseBody(nested, openToken + 1);
        block.children.add(nested);
        block.add(new Block.Entry(property, nameToken, openToken, end, new Value.Nested(nested.content())));
        return end;
    }

    /** Parses properties up to the closing brace, or to a block that cannot be in the braces. */
    private int parseBody(Block nested, int start) {
        int token = start;
        while (true) {
            switch (tokens.kind(token)) {
                case CLOSE -> {
                    nested.closeToken = token;
                    return token + 1;
                }
                case END -> {
                    return expected("'}'", nested, token, token);
                }
                case OPEN -> token = expected("a property", nested, token, tokens.skipBraces(token));
                case NUMBER, BAD_NUMBER, STRING -> token = expected("a property", nested, token, tokens.skipLiterals(token));
                case WORD -> {
                    if (BlockTypes.of(tokens.text(token)).isPresent()) {
                        return expected("'}' before the next block", nested, token, token);
                    }
                    token = parseProperty(nested, token);
                }
            }
        }
    }

    private int parseSingle(Block block, Property<?> property, boolean isExpectedKind, int nameToken, int token) {
        if (!isExpectedKind) {
            String prefix = nameToken < 0 ? "" : property.name() + ": ";
            problem(token, token, block.title() + ": " + prefix + "expected " + property.expected() + ", found " + tokens.describe(token));
            return Parser.isLiteral(tokens.kind(token)) ? token + 1 : token;
        }
        try {
            Value value = value(property, tokens.text(token));
            if (property.form() != Property.Form.QUOTED) {
                // Whether a file can be used is checked when it is read.
                property.checkValue(value);
            }
            block.add(new Block.Entry(property, nameToken, token, token + 1, value));
        } catch (RefusalException e) {
            problem(token, token, block.title() + ": " + e.getMessage());
        }
        return token + 1;
    }

    private Value value(Property<?> property, String text) {
        return switch (property.form()) {
            case WORD -> {
                property.checkWord(text);
                yield new Value.Word(text);
            }
            case NAME -> names.computeIfAbsent(text, Value.Name::new);
            case QUOTED -> new Value.Quoted(text);
            case NUMBERS, LINKS, GAINS, BLOCK -> throw new IllegalStateException(property.name() + " is not a single word");
        };
    }

    private int parseNumbers(Block block, Property<?> property, int nameToken, int start) {
        List<Double> numbers = new ArrayList<>(property.count());
        int token = start;
        while (isNumber(block, token, token - start < property.count())) {
            if (token - start < property.count()) {
                try {
                    numbers.add(parseNumber(property, token - start, token));
                } catch (RefusalException e) {
                    problem(token, token, block.title() + ": " + e.getMessage());
                }
            }
            token++;
        }
        if (token - start != property.count()) {
            problem(nameToken, nameToken, block.title() + ": " + property.name() + " must have " + property.expected()
                    + ", found " + (token - start));
        } else if (numbers.size() == property.count()) {
            addChecked(block, new Block.Entry(property, nameToken, start, token, new Value.Numbers(numbers)));
        }
        return token;
    }

    private void addChecked(Block block, Block.Entry entry) {
        try {
            entry.property().checkValue(entry.value());
            block.add(entry);
        } catch (RefusalException e) {
            problem(entry.from(), entry.from(), block.title() + ": " + e.getMessage());
        }
    }

    /**
     * Parses a number.
     *
     * @throws RefusalException if the token is not a valid number of the property at {@code index}
     */
    double parseNumber(Property<?> property, int index, int token) {
        if (tokens.kind(token) != Kind.NUMBER) {
            throw new RefusalException(property.name() + " must be " + property.expected() + ", found "
                    + tokens.describe(token));
        }
        double number = tokens.number(token);
        if (Double.isInfinite(number)) {
            throw new RefusalException(property.name() + " must be a number within ±1.8e308, found "
                    + tokens.describe(token));
        }
        property.checkNumber(index, number);
        return number;
    }

    /** Returns whether a number, or a string or word in place of a number, follows instead of the next property or block. */
    private boolean isNumber(Block block, int token, boolean isMissing) {
        if (tokens.kind(token) != Kind.WORD) {
            return Parser.isLiteral(tokens.kind(token));
        }
        String word = tokens.text(token);
        return NON_FINITE_WORDS.contains(word.toLowerCase(Locale.ROOT))
                || isMissing && isUnknownWord(block, word) && NameSuggestion.closest(word, block.type.propertyNames()).isEmpty();
    }

    private static boolean isUnknownWord(Block block, String word) {
        return block.type.property(word).isEmpty() && BlockTypes.of(word).isEmpty();
    }

    private int skipValue(Block block, int start) {
        int token = start;
        while (Parser.isLiteral(tokens.kind(token)) || tokens.kind(token) == Kind.WORD && isUnknownWord(block, tokens.text(token))) {
            token++;
        }
        return token;
    }

    private int expected(String what, Block block, int token, int nextToken) {
        return problem(token, nextToken, block.title() + ": expected " + what + ", found " + tokens.describe(token));
    }

    private int problem(int token, int nextToken, String message) {
        problems.add(tokens.start(token), message);
        return nextToken;
    }
}
