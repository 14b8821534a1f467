package lightning.format.jen;

import java.util.Random;

/** Writes the same scene in another way: comments, line ends, spaces and longer numbers anywhere. */
final class Disguise {
    private final Random random;
    private int comments;

    Disguise(Random random) {
        this.random = random;
    }

    String of(String text) {
        Tokens tokens = Lexer.tokens(text, new Problems());
        String newline = random.nextBoolean() ? "\n" : "\r\n";
        var out = new StringBuilder(random.nextInt(4) == 0 ? "\uFEFF" : "");
        for (int i = 0; i < tokens.size() - 1; i++) {
            String word = text.substring(tokens.start(i), tokens.end(i));
            out.append(tokens.kind(i) == Tokens.Kind.NUMBER && i > 1 ? number(word) : word).append(gap(newline, tokens, i));
        }
        return out.toString();
    }

    private String gap(String newline, Tokens tokens, int i) {
        boolean brace = brace(tokens.kind(i)) || brace(tokens.kind(i + 1)) || tokens.kind(i + 1) == Tokens.Kind.END;
        return switch (random.nextInt(6)) {
            case 0 -> newline + "    ";
            case 1 -> "# comment " + comments++ + newline;
            case 2 -> "  # comment " + comments++ + " { \"" + newline + newline;
            case 3 -> brace ? "" : "\t";
            default -> " ";
        };
    }

    private static boolean brace(Tokens.Kind kind) {
        return kind == Tokens.Kind.OPEN || kind == Tokens.Kind.CLOSE;
    }

    /** The same number written otherwise. */
    private String number(String word) {
        boolean plain = word.matches("-?[0-9]+");
        return switch (random.nextInt(4)) {
            case 0 -> plain ? word + ".00" : word;
            case 1 -> word.startsWith("-") ? "-0" + word.substring(1) : "+" + word;
            default -> word;
        };
    }
}
