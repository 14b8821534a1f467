package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import lightning.format.jen.Tokens.Kind;
import lightning.scene.Limits;

/**
 * Reads the blocks of a scene file by recursive descent. After a problem it goes on at the next
 * place that makes sense, so that one run finds all of them.
 */
final class Parser {
    private static final String VERSION = "1";

    private final Tokens tokens;
    private final Problems problems;
    private final PropertyParser properties;
    private final List<Block> top = new ArrayList<>();
    private int at;

    private Parser(Tokens tokens, Problems problems) {
        this.tokens = tokens;
        this.problems = problems;
        this.properties = new PropertyParser(tokens, problems);
    }

    /** All blocks of a file that begins with the version line, which is tokens 0 and 1. */
    static List<Block> file(Tokens tokens, Problems problems) {
        var parser = new Parser(tokens, problems);
        if (parser.version()) {
            parser.blocks();
        }
        return parser.top;
    }

    /** All blocks of a text without a version line. */
    static List<Block> fragment(Tokens tokens, Problems problems) {
        var parser = new Parser(tokens, problems);
        parser.blocks();
        return parser.top;
    }

    private boolean version() {
        if (kind() != Kind.WORD || !tokens.text(at).equals("jen")) {
            problem("a scene file must begin with 'jen 1', found " + tokens.found(at));
            return true;
        }
        at++;
        if (kind() == Kind.NUMBER && tokens.text(at).equals(VERSION)) {
            at++;
            return true;
        }
        problem("expected version 1 of the format, found " + tokens.found(at));
        return kind() != Kind.NUMBER; // another version has another grammar
    }

    private void blocks() {
        while (kind() != Kind.END) {
            switch (kind()) {
                case WORD -> topBlock();
                case CLOSE -> {
                    problem("found a '}' without a '{' before it");
                    at++;
                }
                case OPEN -> {
                    problem("expected a block, found '{'");
                    skipBraces();
                }
                case NUMBER, BAD_NUMBER, STRING -> {
                    problem("expected a block, found " + tokens.found(at));
                    while (isLiteral(kind())) {
                        at++;
                    }
                }
                case END -> throw new AssertionError();
            }
        }
    }

    private void topBlock() {
        String word = tokens.text(at);
        BlockType<?> type = Blocks.of(word).orElse(null);
        if (type == null) {
            problem("expected a block (" + String.join(", ", Blocks.KEYWORDS) + "), found " + tokens.found(at)
                    + Nearest.hint(word, Blocks.KEYWORDS));
            type = Nearest.to(word, Blocks.KEYWORDS).flatMap(Blocks::of).orElse(null);
        }
        if (type == null) {
            at++;
            skipToBlock();
        } else {
            top.add(block(type, 0));
        }
    }

    private Block block(BlockType<?> type, int nesting) {
        var block = new Block(type, at++);
        if (type.named()) {
            name(block);
        }
        type.header().ifPresent(p -> at = properties.header(block, p, at));
        if (nesting >= Limits.MAX_NESTING && type == Blocks.GROUP) {
            problems.add(tokens.start(block.keyword), "groups may be nested " + Limits.MAX_NESTING + " deep at most");
            skipToBlock();
            return block;
        }
        if (type == Blocks.GROUP) {
            while (kind() == Kind.WORD && type.property(tokens.text(at)).isPresent()) {
                at = properties.property(block, at);
            }
        }
        if (kind() != Kind.OPEN) {
            problem(block.title() + ": expected '{', found " + tokens.found(at));
            while (kind() != Kind.OPEN && kind() != Kind.CLOSE && kind() != Kind.END && !startsBlock()) {
                at++;
            }
        }
        if (kind() == Kind.OPEN) {
            block.open = at++;
            body(block, nesting);
        }
        return block;
    }

    private void name(Block block) {
        if (kind() != Kind.WORD && kind() != Kind.STRING) {
            problem(block.type.keyword() + ": expected a name, found " + tokens.found(at));
            if (isLiteral(kind())) {
                at++;
            }
            return;
        }
        block.nameToken = at;
        block.name = tokens.text(at);
        try {
            Limits.name(block.name);
        } catch (IllegalArgumentException e) {
            problem(e.getMessage());
        }
        at++;
    }

    private void body(Block block, int nesting) {
        while (true) {
            switch (kind()) {
                case CLOSE -> {
                    block.close = at++;
                    return;
                }
                case END -> {
                    problem(block.title() + ": expected '}', found " + tokens.found(at));
                    return;
                }
                case OPEN -> {
                    problem(block.title() + ": expected a property, found '{'");
                    skipBraces();
                }
                case NUMBER, BAD_NUMBER, STRING -> {
                    problem(block.title() + ": expected a property, found " + tokens.found(at));
                    while (isLiteral(kind())) {
                        at++;
                    }
                }
                case WORD -> {
                    boolean property = block.type.property(tokens.text(at)).isPresent();
                    if (!startsBlock() || property && !isNamedBlock()) {
                        at = properties.property(block, at);
                    } else if (block.type == Blocks.SHOT) {
                        target(block);
                    } else if (block.type == Blocks.GROUP) {
                        child(block, nesting);
                    } else {
                        problem(block.title() + ": expected '}' before the next block, found " + tokens.found(at));
                        return;
                    }
                }
            }
        }
    }

    private void child(Block group, int nesting) {
        BlockType<?> type = Blocks.of(tokens.text(at)).orElseThrow();
        if (Blocks.NODES.contains(type.keyword())) {
            group.children.add(block(type, nesting + 1));
        } else {
            problem(group.title() + ": a " + type.keyword() + " cannot stand in a group, expected '}' or one of "
                    + String.join(", ", Blocks.NODES));
            top.add(block(type, 0));
        }
    }

    /** Reads what has keys in a shot. */
    private void target(Block shot) {
        BlockType<?> type = Blocks.of(tokens.text(at)).orElseThrow();
        if (!Blocks.KEYED.contains(type.keyword())) {
            problem("shot: a " + type.keyword() + " has no keys, expected '}' or one of " + String.join(", ", Blocks.KEYED));
            at++;
            skipToBlock();
            return;
        }
        var target = new Block(type, at++);
        if (type.named()) {
            name(target);
        }
        if (kind() == Kind.OPEN) {
            target.open = at++;
            at = new KeyParser(tokens, problems, properties, target).body(at);
            shot.children.add(target);
        } else {
            problem(target.title() + ": expected '{' and keys, found " + tokens.found(at));
            skipToBlock();
        }
    }

    private boolean startsBlock() {
        return kind() == Kind.WORD && Blocks.of(tokens.text(at)).isPresent();
    }

    /** Whether {@code material name \{} stands here and not the property {@code material name}. */
    private boolean isNamedBlock() {
        return tokens.isName(at + 1) && tokens.kind(at + 2) == Kind.OPEN;
    }

    /** Goes behind the next closed pair of braces, or to the next block, or to the end. */
    private void skipToBlock() {
        while (kind() != Kind.END && kind() != Kind.CLOSE && !startsBlock()) {
            if (kind() == Kind.OPEN) {
                skipBraces();
                return;
            }
            at++;
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
            at++;
        } while (depth > 0);
    }

    private static boolean isLiteral(Kind kind) {
        return kind == Kind.NUMBER || kind == Kind.BAD_NUMBER || kind == Kind.STRING;
    }

    /** The kind of the next token; the end as soon as there are too many problems. */
    private Kind kind() {
        return problems.isFull() ? Kind.END : tokens.kind(at);
    }

    private void problem(String message) {
        problems.add(tokens.start(at), message);
    }
}
