package lightning.format.jen;

import java.util.Random;

/** Rewrites a scene text with the same meaning: other comments, line ends, spaces and longer numbers. */
final class TextReformatter {
    private final Random random;
    private int comments;

    TextReformatter(Random random) {
        this.random = random;
    }

    String reformat(String text) {
        TokenList tokens = Lexer.tokens(text, new ProblemList());
        String newline = random.nextBoolean() ? "\n" : "\r\n";
        var out = new StringBuilder(random.nextInt(4) == 0 ? "\uFEFF" : "");
        for (int i = 0; i < tokens.size() - 1; i++) {
            String token = text.substring(tokens.start(i), tokens.end(i));
            out.append(tokens.kind(i) == TokenList.Kind.NUMBER && i > 1 ? number(token) : token).append(separator(newline, tokens, i));
        }
        return out.toString();
    }

    private String separator(String newline, TokenList tokens, int i) {
        boolean nextToBrace = isBrace(tokens.kind(i)) || isBrace(tokens.kind(i + 1)) || tokens.kind(i + 1) == TokenList.Kind.END;
        return switch (random.nextInt(6)) {
            case 0 -> newline + "    ";
            case 1 -> "# comment " + comments++ + newline;
            case 2 -> "  # comment " + comments++ + " { \"" + newline + newline;
            case 3 -> nextToBrace ? "" : "\t";
            default -> " ";
        };
    }

    private static boolean isBrace(TokenList.Kind kind) {
        return kind == TokenList.Kind.OPEN || kind == TokenList.Kind.CLOSE;
    }

    /** Returns another spelling of a number. */
    private String number(String digits) {
        boolean isInteger = digits.matches("-?[0-9]+");
        return switch (random.nextInt(4)) {
            case 0 -> isInteger ? digits + ".00" : digits;
            case 1 -> digits.startsWith("-") ? "-0" + digits.substring(1) : "+" + digits;
            default -> digits;
        };
    }
}
