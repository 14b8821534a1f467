package lightning.editor.window;

import org.junit.jupiter.api.extension.RegisterExtension;

/** Runs the lighting story in a locale with other digits. */
class LightingStoryInEgyptTest extends LightingStoryTest {
    @RegisterExtension
    static final DefaultLocaleExtension LOCALE = new DefaultLocaleExtension("ar", "EG");
}
