package lightning.format.jen.asset;

import java.util.regex.Pattern;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/** Validation of file names in scene files. */
public final class FileName {
    private static final Pattern ALLOWED = Pattern.compile("[\\p{L}\\p{N} _.,()+/-]{1,200}");

    private FileName() {}

    public static boolean isAllowed(String file) {
        try {
            check("file", file, "");
            return true;
        } catch (RefusalException e) {
            return false;
        }
    }

    /**
     * Checks a file name.
     *
     * @param property property with the name, for messages
     * @param folder asset folder next to the scene, for messages
     * @throws RefusalException if {@code file} is not a relative path of plain names separated by {@code /}, at most
     *     200 characters, without empty names, {@code .} and {@code ..}
     */
    public static void check(String property, String file, String folder) {
        if (!ALLOWED.matcher(file).matches()) {
            throw new RefusalException(property + " must be a file name of 1 to 200 letters, digits, spaces and "
                    + "_ . , ( ) + - /, was " + Quote.of(file));
        }
        if (file.startsWith("/")) {
            throw new RefusalException(property + " must be a file next to the scene or in its " + folder + " folder, "
                    + "was the absolute path " + Quote.of(file));
        }
        for (String name : file.split("/", -1)) {
            if (name.isEmpty() || name.equals(".") || name.equals("..")) {
                throw new RefusalException(property + " must be a path without empty names, . and .., was " + Quote.of(file));
            }
        }
    }
}
