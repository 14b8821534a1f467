package lightning.format.jen;

import lightning.base.text.Quote;

/**
 * One thing that is wrong with a scene file.
 *
 * @param file    the file as the user named it
 * @param line    from 1
 * @param column  from 1, counted in characters (Unicode code points; a tab counts as one)
 * @param message what is wrong, what was expected and what was found, in one line
 */
public record Problem(String file, int line, int column, String message) {
    /** {@code file:line:column: message}. */
    @Override
    public String toString() {
        return Quote.path(file) + ":" + line + ":" + column + ": " + message;
    }
}
