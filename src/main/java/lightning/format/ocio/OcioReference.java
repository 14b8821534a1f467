package lightning.format.ocio;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/**
 * Reference to a view in options: {@code ocio:DISPLAY/VIEW} of the configuration that the environment names, or {@code
 * ocio:config.ocio#DISPLAY/VIEW}. A built-in configuration needs no second {@code ocio:}, as in {@code ocio://default#DISPLAY/VIEW}.
 *
 * @param config file or name of the configuration
 * @param view   as for {@link OcioConfig#find}
 */
public record OcioReference(String config, String view) {
    /** Environment variable that names a configuration, as in all programs with OpenColorIO. */
    public static final String VARIABLE = "OCIO";

    private static final String WORD = "ocio";

    /** Returns whether a text is a reference. */
    public static boolean isReference(String text) {
        return text.equals(WORD) || text.startsWith(WORD + ":");
    }

    /**
     * Returns the reference of a text.
     *
     * @param environment value of the variable; null or empty for none
     * @throws IOException if neither the text nor the environment has a configuration
     */
    public static OcioReference parse(String text, @Nullable String environment) throws IOException {
        String rest = text.startsWith(OcioConverter.BUILT_IN) ? text : text.substring(Math.min(text.length(), WORD.length() + 1));
        int hash = rest.indexOf('#');
        boolean hasConfig = hash >= 0 || rest.startsWith(OcioConverter.BUILT_IN);
        return hasConfig ? new OcioReference(hash < 0 ? rest : rest.substring(0, hash), hash < 0 ? "" : rest.substring(hash + 1))
                : new OcioReference(config("", environment), rest);
    }

    /**
     * Returns a configuration that is named, or that of the environment.
     *
     * @param named empty for none
     * @throws IOException if there is none
     */
    public static String config(String named, @Nullable String environment) throws IOException {
        if (!named.isEmpty()) {
            return named;
        }
        if (environment == null || environment.isEmpty()) {
            throw new IOException("OpenColorIO: expected a configuration, found none; set the environment variable " + VARIABLE
                    + ", or name a file or ocio://default");
        }
        return environment;
    }
}
