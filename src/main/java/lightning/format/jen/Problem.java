package lightning.format.jen;

import lightning.base.text.Quote;

/**
 * Problem in a scene file.
 *
 * @param file path as given by the user
 * @param line from 1
 * @param column from 1, in Unicode code points; a tab counts as one
 * @param message cause, expected and found content, in one line
 */
public record Problem(String file, int line, int column, String message) {
    /** Returns {@code file:line:column: message}. */
    @Override
    public String toString() {
        return Quote.path(file) + ":" + line + ":" + column + ": " + message;
    }
}
