package lightning.editor.window;

import org.junit.jupiter.api.extension.RegisterExtension;

/** The same afternoon where other digits are used. */
class LightingStoryInEgyptTest extends LightingStoryTest {
    @RegisterExtension
    static final DefaultLocaleExtension LOCALE = new DefaultLocaleExtension("ar", "EG");
}
