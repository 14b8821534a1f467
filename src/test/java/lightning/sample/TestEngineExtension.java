package lightning.sample;

import lightning.render.engine.choice.Engines;
import net.jqwik.api.lifecycle.BeforeContainerHook;
import net.jqwik.api.lifecycle.ContainerLifecycleContext;
import net.jqwik.api.lifecycle.PropagationMode;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** Runs every test that names no engine with both engines, chosen tile by tile. JUnit and jqwik load it as a service. */
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
