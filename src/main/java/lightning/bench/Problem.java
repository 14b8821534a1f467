package lightning.bench;

/**
 * Something that could not be measured, while the rest was.
 *
 * @param where the scene's file, its size and the edit, as far as known
 * @param what  a sentence
 */
public record Problem(String where, String what) {}
