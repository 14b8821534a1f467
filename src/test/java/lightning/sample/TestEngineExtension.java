package lightning.sample;

import lightning.render.engine.choice.Engines;
import net.jqwik.api.lifecycle.BeforeContainerHook;
import net.jqwik.api.lifecycle.ContainerLifecycleContext;
import net.jqwik.api.lifecycle.PropagationMode;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Makes every test that names no engine run on both, tile by tile. Found by JUnit and jqwik as a service. */
public final class TestEngineExtension implements BeforeAllCallback, BeforeContainerHook {
    private static final long MIXED = 2;

    @Override
    public void beforeAll(ExtensionContext context) {
        use();
    }

    @Override
    public void beforeContainer(ContainerLifecycleContext context) {
        use();
    }

    @Override
    public PropagationMode propagateTo() {
        return PropagationMode.ALL_DESCENDANTS;
    }

    private static void use() {
        Engines.use(new MixedEngineChoice(MIXED));
    }
}
