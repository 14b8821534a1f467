package lightning.sample;

import java.util.Locale;
import java.util.ResourceBundle;
import java.util.concurrent.Callable;

/** Temporary change of the default locale, to show that no code depends on it. */
public final class DefaultLocale {
    private DefaultLocale() {}

    /** Sets it; returns the previous one. */
    public static Locale set(Locale locale) {
        Locale before = Locale.getDefault();
        Locale.setDefault(locale);
        return before;
    }

    /** Runs work under a locale. */
    public static <T> T during(Locale locale, Callable<T> work) throws Exception {
        Locale before = set(locale);
        try {
            return work.call();
        } finally {
            Locale.setDefault(before);
        }
    }

    /** Returns a text of a third-party bundle for the default locale. */
    public static String text(String bundle, String key) {
        return ResourceBundle.getBundle(bundle).getString(key);
    }
}
