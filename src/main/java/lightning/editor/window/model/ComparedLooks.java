package lightning.editor.window.model;

/**
 * Two saved looks that are shown beside each other.
 *
 * @param a name of the left one
 * @param b name of the right one
 */
public record ComparedLooks(String a, String b) {}
