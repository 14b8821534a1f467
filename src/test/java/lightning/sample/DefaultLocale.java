package lightning.sample;

import java.util.Locale;
import java.util.ResourceBundle;
import java.util.concurrent.Callable;

/** Another default locale for a while, to show that nothing follows it: the one place that may ask for it. */
public final class DefaultLocale {
    private DefaultLocale() {}

    /** Sets it; returns the one before. */
    public static Locale set(Locale locale) {
        Locale before = Locale.getDefault();
        Locale.setDefault(locale);
        return before;
    }

    /** Does some work under it. */
    public static <T> T during(Locale locale, Callable<T> work) throws Exception {
        Locale before = set(locale);
        try {
            return work.call();
        } finally {
            Locale.setDefault(before);
        }
    }

    /** What a bundle of others has for the locale that is the default. */
    public static String text(String bundle, String key) {
        return ResourceBundle.getBundle(bundle).getString(key);
    }
}
