package lightning.editor.window;

import org.junit.jupiter.api.extension.RegisterExtension;

/** The same afternoon where other letters are used. */
class LightingStoryInTurkeyTest extends LightingStoryTest {
    @RegisterExtension
    static final DefaultLocaleExtension LOCALE = new DefaultLocaleExtension("tr", "TR");
}
