package lightning.editor.window;

import java.util.Locale;
import lightning.sample.DefaultLocale;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Runs a class of tests under another default locale. */
final class StoryAbroad implements BeforeAllCallback, AfterAllCallback {
    private final Locale abroad;
    private Locale home;

    StoryAbroad(String language, String country) {
        abroad = Locale.of(language, country);
    }

    @Override
    public void beforeAll(ExtensionContext context) {
        home = DefaultLocale.set(abroad);
    }

    @Override
    public void afterAll(ExtensionContext context) {
        DefaultLocale.set(home);
    }
}
