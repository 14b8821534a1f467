package lightning.editor.window;

import java.util.Locale;
import lightning.sample.DefaultLocale;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Runs a test class under another default locale. */
final class DefaultLocaleExtension implements BeforeAllCallback, AfterAllCallback {
    private final Locale locale;
    private Locale defaultLocale;

    DefaultLocaleExtension(String language, String country) {
        locale = Locale.of(language, country);
    }

    @Override
    public void beforeAll(ExtensionContext context) {
        defaultLocale = DefaultLocale.set(locale);
    }

    @Override
    public void afterAll(ExtensionContext context) {
        DefaultLocale.set(defaultLocale);
    }
}
