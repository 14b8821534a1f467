package lightning.editor.window;

import org.junit.jupiter.api.extension.RegisterExtension;

/** Runs the lighting story in a locale with other case rules. */
class LightingStoryInTurkeyTest extends LightingStoryTest {
    @RegisterExtension
    static final DefaultLocaleExtension LOCALE = new DefaultLocaleExtension("tr", "TR");
}
