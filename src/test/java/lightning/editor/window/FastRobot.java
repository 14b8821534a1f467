package lightning.editor.window;

import com.sun.javafx.scene.NodeHelper;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import javafx.event.Event;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination.ModifierValue;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.robot.Robot;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.work.Await;
import lightning.editor.window.widget.TimeSlicedTask;
import org.testfx.api.FxRobot;
import org.testfx.matcher.base.NodeMatchers;
import org.testfx.robot.Motion;
import org.testfx.service.query.PointQuery;
import org.testfx.util.WaitForAsyncUtils;

/**
 * TestFX robot without pauses. TestFX waits at least 50 ms after each action; this robot waits until the window has handled the action and
 * is laid out.
 */
public final class FastRobot extends FxRobot {
    private static final int ROUNDS = 3;
    private static final int PULSES = 2;
    private static final int DRAG_STEPS = 8;
    private static final List<KeyCode> MODIFIERS = List.of(KeyCode.SHIFT, KeyCode.CONTROL, KeyCode.ALT);

    private static List<Window> windowsBefore = List.of();
    /**
     * Shared by all tests: on the headless platform, a closed window keeps its robot and each robot keeps the last window that it was used
     * in.
     */
    private static Robot robot;

    private final List<MouseButton> pressed = new ArrayList<>();

    private void act(Runnable action) {
        await(() -> {
            action.run();
            return null;
        });
        settle();
    }

    private static Robot robot() {
        if (robot == null) {
            robot = new Robot();
        }
        return robot;
    }

    /**
     * Focuses a window if none is focused. A desktop does this when a window closes; the headless platform does not, and its robot would
     * fail.
     */
    private static void keepFocus() {
        List<Window> windows = List.copyOf(Window.getWindows());
        if (windows.stream().noneMatch(Window::isFocused)) {
            windows.stream().filter(window -> window instanceof Stage && window.isShowing()).reduce((_, last) -> last)
                    .ifPresent(Window::requestFocus);
        }
    }

    /** Runs a task on the window's thread and rethrows its exceptions. */
    private static <T> T await(Callable<T> what) {
        try {
            return Platform.isFxApplicationThread() ? what.call()
                    : WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, WaitForAsyncUtils.asyncFx(what));
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    /** Waits until all windows have handled their events and are positioned and laid out. */
    public static void settle() {
        layOut();
        List<Window> windows = await(() -> List.copyOf(Window.getWindows()));
        if (windows.size() > 1 && !windowsBefore.containsAll(windows)) {
            awaitPulses();
            layOut();
        }
        awaitSlicedTasks();
        windowsBefore = windows;
    }

    /** A window that positions itself next to its owner is shown only after the next pulse. */
    private static void awaitPulses() {
        var pulses = new CountDownLatch(PULSES);
        await(() -> {
            new AnimationTimer() {
                @Override
                public void handle(long now) {
                    pulses.countDown();
                    if (pulses.getCount() == 0) {
                        stop();
                    }
                }
            }.start();
            return null;
        });
        try {
            if (!pulses.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
                throw new AssertionError("the window was not drawn within " + Await.TIMEOUT_SECONDS + " s");
            }
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /** Waits for content that is added over several pulses. */
    private static void awaitSlicedTasks() {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(Await.TIMEOUT_SECONDS);
        while (await(TimeSlicedTask::isAnyRunning)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("time-sliced tasks were still running after " + Await.TIMEOUT_SECONDS + " s");
            }
            awaitPulses();
        }
    }

    private static void layOut() {
        for (int i = 0; i < ROUNDS; i++) {
            await(() -> {
                for (Window window : List.copyOf(Window.getWindows())) {
                    Scene scene = window.getScene();
                    if (scene != null && scene.getRoot() != null) {
                        // As in a pulse: skips styles that are up to date, unlike Node.applyCss.
                        NodeHelper.processCSS(scene.getRoot());
                        scene.getRoot().layout();
                    }
                }
                return null;
            });
        }
    }

    @Override
    public FxRobot interact(Runnable what) {
        act(what);
        return this;
    }

    /** A new node has no position before the layout, so this waits first and follows moving targets. */
    @Override
    public FxRobot moveTo(PointQuery to, Motion motion) {
        settle();
        Point2D place = await(to::query);
        moveCursor(place);
        Point2D now = await(to::query);
        if (pressed.isEmpty() && !now.equals(place)) {
            moveCursor(now);
        }
        return this;
    }

    @Override
    public FxRobot moveBy(double x, double y, Motion motion) {
        moveCursor(await(() -> robot().getMousePosition()).add(x, y));
        return this;
    }

    /** Starts slowly, so that the movement is recognized as a drag. */
    private void moveCursor(Point2D to) {
        Point2D from = await(() -> robot().getMousePosition());
        int steps = pressed.isEmpty() ? 2 : DRAG_STEPS;
        for (int i = 1; i <= steps; i++) {
            double share = (double) i * i / (steps * steps);
            act(() -> robot().mouseMove(from.interpolate(to, share)));
        }
    }

    private static MouseButton[] orPrimary(MouseButton[] buttons) {
        return buttons.length == 0 ? new MouseButton[] {MouseButton.PRIMARY} : buttons;
    }

    @Override
    public FxRobot press(MouseButton... buttons) {
        MouseButton[] which = orPrimary(buttons);
        act(() -> {
            keepFocus();
            robot().mousePress(which);
        });
        pressed.addAll(List.of(which));
        return this;
    }

    @Override
    public FxRobot release(MouseButton... buttons) {
        MouseButton[] which = buttons.length == 0 ? pressed.toArray(MouseButton[]::new) : buttons;
        if (which.length > 0) {
            act(() -> robot().mouseRelease(which));
        }
        pressed.removeAll(List.of(which));
        return this;
    }

    @Override
    public FxRobot clickOn(MouseButton... buttons) {
        press(orPrimary(buttons));
        return release(orPrimary(buttons));
    }

    /** TestFX looks up the node and its bounds in the calling thread, which sees windows half changed. */
    @Override
    public FxRobot clickOn(String query, Motion motion, MouseButton... buttons) {
        return clickOn(await(() -> point(lookup(query).match(NodeMatchers.isVisible()).<Node>query())), motion, buttons);
    }

    @Override
    public FxRobot clickOn(PointQuery at, Motion motion, MouseButton... buttons) {
        moveTo(at, motion);
        return clickOn(buttons);
    }

    @Override
    public FxRobot doubleClickOn(PointQuery at, Motion motion, MouseButton... buttons) {
        moveTo(at, motion);
        clickOn(buttons);
        return clickOn(buttons);
    }

    @Override
    public FxRobot drag(PointQuery from, MouseButton... buttons) {
        moveTo(from, Motion.DIRECT);
        return press(buttons);
    }

    @Override
    public FxRobot drag(MouseButton... buttons) {
        return press(buttons);
    }

    @Override
    public FxRobot drop() {
        return release(new MouseButton[0]);
    }

    @Override
    public FxRobot dropTo(PointQuery to) {
        moveTo(to, Motion.DIRECT);
        return drop();
    }

    @Override
    public FxRobot dropBy(double x, double y) {
        moveBy(x, y, Motion.DIRECT);
        return drop();
    }

    /** Returns the key of a non-Mac keyboard. */
    private static KeyCode platformKey(KeyCode key) {
        return key == KeyCode.SHORTCUT ? KeyCode.CONTROL : key;
    }

    @Override
    public FxRobot press(KeyCode... keys) {
        for (KeyCode key : keys) {
            act(() -> {
                keepFocus();
                robot().keyPress(platformKey(key));
            });
        }
        return this;
    }

    @Override
    public FxRobot release(KeyCode... keys) {
        for (KeyCode key : keys.length == 0 ? MODIFIERS.toArray(KeyCode[]::new) : keys) {
            act(() -> robot().keyRelease(platformKey(key)));
        }
        return this;
    }

    @Override
    public FxRobot push(KeyCode... keys) {
        press(keys);
        for (int i = keys.length; i-- > 0;) {
            release(keys[i]);
        }
        return this;
    }

    @Override
    public FxRobot type(KeyCode... keys) {
        for (KeyCode key : keys) {
            push(key);
        }
        return this;
    }

    @Override
    public FxRobot type(KeyCode key, int times) {
        for (int i = 0; i < times; i++) {
            push(key);
        }
        return this;
    }

    @Override
    public FxRobot push(KeyCodeCombination keys) {
        List<KeyCode> all = new ArrayList<>();
        if (keys.getShift() == ModifierValue.DOWN) {
            all.add(KeyCode.SHIFT);
        }
        if (keys.getControl() == ModifierValue.DOWN || keys.getShortcut() == ModifierValue.DOWN) {
            all.add(KeyCode.CONTROL);
        }
        if (keys.getAlt() == ModifierValue.DOWN) {
            all.add(KeyCode.ALT);
        }
        all.add(keys.getCode());
        return push(all.toArray(KeyCode[]::new));
    }

    @Override
    public FxRobot write(String text) {
        act(() -> {
            // Of two focused windows, the later one was opened from the other.
            Scene scene = Window.getWindows().stream().filter(Window::isFocused).reduce((_, last) -> last).orElseThrow().getScene();
            for (String character : text.split("")) {
                Node owner = scene.getFocusOwner();
                Event.fireEvent(owner == null ? scene : owner, new KeyEvent(KeyEvent.KEY_TYPED, character, character,
                        KeyCode.UNDEFINED, false, false, false, false));
            }
        });
        return this;
    }
}
