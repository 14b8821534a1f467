package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.RefusalException;
import lightning.format.jen.TokenList.Kind;
import lightning.format.jen.asset.NameSuggestion;
import lightning.scene.value.SceneLimits;

/**
 * Recursive-descent parser for the blocks of a scene file. After a problem it resumes at the next plausible token, so that
 * one run finds all problems.
 */
final class Parser {
    private static final String VERSION = "1";

    private final TokenList tokens;
    private final ProblemList problems;
    private final PropertyParser properties;
    private final List<Block> blocks = new ArrayList<>();
    private int position;

    private Parser(TokenList tokens, ProblemList problems) {
        this.tokens = tokens;
        this.problems = problems;
        this.properties = new PropertyParser(tokens, problems);
    }

    /** Returns whether a file begins as a scene file, or as one without its version line; an empty one counts. */
    static boolean isSceneFile(TokenList tokens) {
        return switch (tokens.kind(0)) {
            case WORD -> tokens.text(0).equals("jen") || BlockTypes.KEYWORDS.contains(tokens.text(0));
            case END -> true;
            case STRING, NUMBER, BAD_NUMBER, OPEN, CLOSE -> false;
        };
    }

    /** Parses all blocks of a file, whose tokens 0 and 1 are the version line. */
    static List<Block> parseFile(TokenList tokens, ProblemList problems) {
        var parser = new Parser(tokens, problems);
        if (parser.parseVersion()) {
            parser.parseBlocks();
        }
        return parser.blocks;
    }

    /** Parses all blocks of a text without a version line. */
    static List<Block> parseFragment(TokenList tokens, ProblemList problems) {
        var parser = new Parser(tokens, problems);
        parser.parseBlocks();
        return parser.blocks;
    }

    private boolean parseVersion() {
        if (kind() != Kind.WORD || !tokens.text(position).equals("jen")) {
            problem("a scene file must begin with 'jen 1', found " + tokens.describe(position));
            return true;
        }
        position++;
        if (kind() == Kind.NUMBER && tokens.text(position).equals(VERSION)) {
            position++;
            return true;
        }
        problem("expected version 1 of the format, found " + tokens.describe(position));
        return kind() != Kind.NUMBER; // another version has a different grammar
    }

    private void parseBlocks() {
        while (kind() != Kind.END) {
            switch (kind()) {
                case WORD -> parseTopBlock();
                case CLOSE -> {
                    problem("found a '}' without a '{' before it");
                    position++;
                }
                case OPEN -> {
                    problem("expected a block, found '{'");
                    skipBraces();
                }
                case NUMBER, BAD_NUMBER, STRING -> {
                    problem("expected a block, found " + tokens.describe(position));
                    while (isLiteral(kind())) {
                        position++;
                    }
                }
                case END -> throw new AssertionError();
            }
        }
    }

    private void parseTopBlock() {
        String word = tokens.text(position);
        BlockType<?> type = BlockTypes.of(word).orElse(null);
        if (type == null) {
            problem("expected a block (" + String.join(", ", BlockTypes.KEYWORDS) + "), found " + tokens.describe(position)
                    + NameSuggestion.hint(word, BlockTypes.KEYWORDS));
            type = NameSuggestion.closest(word, BlockTypes.KEYWORDS).flatMap(BlockTypes::of).orElse(null);
        }
        if (type == null) {
            position++;
            skipToBlock();
        } else {
            blocks.add(parseBlock(type == BlockTypes.CAMERA && tokens.isName(position + 1) ? BlockTypes.NAMED_CAMERA : type, 0));
        }
    }

    private Block parseBlock(BlockType<?> type, int nesting) {
        var block = new Block(type, position++);
        if (type.isNamed()) {
            parseName(block);
        }
        type.header().ifPresent(p -> position = properties.parseHeader(block, p, position));
        if (nesting >= SceneLimits.MAX_NESTING && type == BlockTypes.GROUP) {
            problems.add(tokens.start(block.keywordToken), "groups may be nested " + SceneLimits.MAX_NESTING + " deep at most");
            skipToBlock();
            return block;
        }
        if (type == BlockTypes.GROUP) {
            while (kind() == Kind.WORD && type.property(tokens.text(position)).isPresent()) {
                position = properties.parseProperty(block, position);
            }
        }
        if (kind() != Kind.OPEN) {
            problem(block.title() + ": expected '{', found " + tokens.describe(position));
            while (kind() != Kind.OPEN && kind() != Kind.CLOSE && kind() != Kind.END && !startsBlock()) {
                position++;
            }
        }
        if (kind() == Kind.OPEN) {
            block.openToken = position++;
            parseBody(block, nesting);
        }
        return block;
    }

    private void parseName(Block block) {
        if (kind() != Kind.WORD && kind() != Kind.STRING) {
            problem(block.type.keyword() + ": expected a name, found " + tokens.describe(position));
            if (isLiteral(kind())) {
                position++;
            }
            return;
        }
        block.nameToken = position;
        block.name = tokens.text(position);
        try {
            SceneLimits.checkName(block.name);
        } catch (RefusalException e) {
            problem(e.getMessage());
        }
        position++;
    }

    private void parseBody(Block block, int nesting) {
        while (true) {
            switch (kind()) {
                case CLOSE -> {
                    block.closeToken = position++;
                    return;
                }
                case END -> {
                    problem(block.title() + ": expected '}', found " + tokens.describe(position));
                    return;
                }
                case OPEN -> {
                    problem(block.title() + ": expected a property, found '{'");
                    skipBraces();
                }
                case NUMBER, BAD_NUMBER, STRING -> {
                    problem(block.title() + ": expected a property, found " + tokens.describe(position));
                    while (isLiteral(kind())) {
                        position++;
                    }
                }
                case WORD -> {
                    boolean isProperty = block.type.property(tokens.text(position)).isPresent();
                    if (!startsBlock() || isProperty && !isNamedBlock()) {
                        position = properties.parseProperty(block, position);
                    } else if (block.type == BlockTypes.SHOT) {
                        parseTarget(block);
                    } else if (block.type == BlockTypes.GROUP) {
                        parseChild(block, nesting);
                    } else {
                        problem(block.title() + ": expected '}' before the next block, found " + tokens.describe(position));
                        return;
                    }
                }
            }
        }
    }

    private void parseChild(Block group, int nesting) {
        BlockType<?> type = BlockTypes.of(tokens.text(position)).orElseThrow();
        if (BlockTypes.NODE_KEYWORDS.contains(type.keyword())) {
            group.children.add(parseBlock(type, nesting + 1));
        } else {
            problem(group.title() + ": a " + type.keyword() + " cannot stand in a group, expected '}' or one of "
                    + String.join(", ", BlockTypes.NODE_KEYWORDS));
            blocks.add(parseBlock(type, 0));
        }
    }

    /** Parses an animated block in a shot. */
    private void parseTarget(Block shot) {
        BlockType<?> type = BlockTypes.of(tokens.text(position)).orElseThrow();
        if (!BlockTypes.KEYED_KEYWORDS.contains(type.keyword())) {
            problem("shot: a " + type.keyword() + " has no keys, expected '}' or one of " + String.join(", ", BlockTypes.KEYED_KEYWORDS));
            position++;
            skipToBlock();
            return;
        }
        var target = new Block(type, position++);
        if (type.isNamed()) {
            parseName(target);
        }
        if (kind() == Kind.OPEN) {
            target.openToken = position++;
            position = new KeyframeParser(tokens, problems, properties, target).parseBody(position);
            shot.children.add(target);
        } else {
            problem(target.title() + ": expected '{' and keys, found " + tokens.describe(position));
            skipToBlock();
        }
    }

    private boolean startsBlock() {
        return kind() == Kind.WORD && BlockTypes.of(tokens.text(position)).isPresent();
    }

    /** Returns whether a block {@code material name {}} follows rather than the property {@code material name}. */
    private boolean isNamedBlock() {
        return tokens.isName(position + 1) && tokens.kind(position + 2) == Kind.OPEN;
    }

    /** Skips past the next closed pair of braces, or to the next block or the end. */
    private void skipToBlock() {
        while (kind() != Kind.END && kind() != Kind.CLOSE && !startsBlock()) {
            if (kind() == Kind.OPEN) {
                skipBraces();
                return;
            }
            position++;
        }
    }

    private void skipBraces() {
        int depth = 0;
        do {
            switch (kind()) {
                case OPEN -> depth++;
                case CLOSE -> depth--;
                case END -> {
                    return;
                }
                case WORD, NUMBER, BAD_NUMBER, STRING -> {}
            }
            position++;
        } while (depth > 0);
    }

    static boolean isLiteral(Kind kind) {
        return kind == Kind.NUMBER || kind == Kind.BAD_NUMBER || kind == Kind.STRING;
    }

    /** Returns the kind of the next token; END once there are too many problems. */
    private Kind kind() {
        return problems.isFull() ? Kind.END : tokens.kind(position);
    }

    private void problem(String message) {
        problems.add(tokens.start(position), message);
    }
}
