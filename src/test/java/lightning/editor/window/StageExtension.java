package lightning.editor.window;

import java.lang.annotation.Annotation;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import javafx.stage.Stage;
import lightning.base.work.Await;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;
import org.testfx.util.WaitForAsyncUtils;

/**
 * Gives each test its own stage on the shared toolkit, and a {@link FastRobot}. The method with {@link Start} fills the stage; the method
 * with {@link Stop} cleans up.
 */
public final class StageExtension implements BeforeEachCallback, AfterEachCallback, ParameterResolver {
    private final FastRobot robot = new FastRobot();
    private Stage stage;

    @Override
    public void beforeEach(ExtensionContext context) throws Exception {
        FxToolkit.registerPrimaryStage();
        onFxThread(() -> {
            stage = new Stage();
            run(context, Start.class, stage);
        });
        FastRobot.settle();
    }

    @Override
    public void afterEach(ExtensionContext context) throws Exception {
        robot.release(new javafx.scene.input.MouseButton[0]);
        robot.release(new javafx.scene.input.KeyCode[0]);
        onFxThread(() -> {
            run(context, Stop.class);
            stage.close();
        });
    }

    private interface FxStep {
        void run() throws Exception;
    }

    private static void onFxThread(FxStep step) throws Exception {
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, WaitForAsyncUtils.asyncFx(() -> {
            step.run();
            return null;
        }));
    }

    private static void run(ExtensionContext context, Class<? extends Annotation> mark, Object... arguments) throws Exception {
        for (Method method : context.getRequiredTestClass().getDeclaredMethods()) {
            if (method.isAnnotationPresent(mark)) {
                method.setAccessible(true);
                method.invoke(context.getRequiredTestInstance(), Arrays.copyOf(arguments, method.getParameterCount()));
            }
        }
    }

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        return parameter.getParameter().getType() == FxRobot.class;
    }

    @Override
    public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
        return robot;
    }
}
