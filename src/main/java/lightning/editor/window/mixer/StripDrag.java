package lightning.editor.window.mixer;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import lightning.editor.document.Change;
import lightning.editor.document.Channel;
import lightning.editor.document.ChannelEdits;
import lightning.scene.Scene;

/** The mouse on the heads of strips: a click selects, a drag puts a light to another place of the scene's order. */
final class StripDrag {
    /** A hand that clicks moves a little, pixels. */
    private static final double CLICK = 5;

    private final Board board;
    private final Supplier<List<Strip>> shown;
    private Strip pressed;
    private double pressX;
    private boolean dragging;

    /** @param shown the strips that are seen, from the left */
    StripDrag(Board board, Supplier<List<Strip>> shown) {
        this.board = board;
        this.shown = shown;
    }

    void on(HBox row) {
        row.addEventHandler(MouseEvent.MOUSE_PRESSED, this::press);
        row.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::drag);
        row.addEventHandler(MouseEvent.MOUSE_RELEASED, this::release);
    }

    private void press(MouseEvent e) {
        pressed = shown.get().stream().filter(s -> isIn(e, s.head())).findFirst().orElse(null);
        pressX = e.getSceneX();
        dragging = false;
    }

    private static boolean isIn(MouseEvent e, Node part) {
        for (Node n = e.getTarget() instanceof Node target ? target : null; n != null; n = n.getParent()) {
            if (n == part) {
                return true;
            }
        }
        return false;
    }

    private void drag(MouseEvent e) {
        if (pressed != null && !(pressed.channel() instanceof Channel.OfEnvironment)
                && (dragging || Math.abs(e.getSceneX() - pressX) > CLICK)) {
            dragging = true;
            pressed.setDragged(true);
            Optional<Strip> next = place(pressed.channel(), e.getSceneX());
            shown.get().forEach(s -> s.setDrop(next.isPresent() && s == next.get()));
        }
    }

    /** The strip that a dragged one would come before; empty at the end. */
    private Optional<Strip> next(double x) {
        return shown.get().stream().filter(s -> s.localToScene(s.getBoundsInLocal()).getCenterX() > x).findFirst();
    }

    /** Where it would be dropped: a bank comes before a bank, or behind all. */
    private Optional<Strip> place(Channel dragged, double x) {
        return dragged instanceof Channel.OfBank ? shown.get().stream().filter(s -> s.channel() instanceof Channel.OfBank)
                .filter(s -> s.localToScene(s.getBoundsInLocal()).getCenterX() > x).findFirst() : next(x);
    }

    private static Optional<String> bank(Optional<Strip> strip) {
        return strip.map(Strip::channel).map(Channel::title);
    }

    private void release(MouseEvent e) {
        if (pressed == null) {
            return;
        }
        Strip strip = pressed;
        pressed = null;
        shown.get().forEach(s -> s.setDrop(false));
        strip.setDragged(false);
        if (dragging) {
            Optional<Strip> next = place(strip.channel(), e.getSceneX());
            if (next.isEmpty() || next.get() != strip) {
                board.edit(scene -> switch (strip.channel()) {
                    case Channel.OfLight(String light) -> drop(scene, light, next);
                    case Channel.OfBank(String bank) -> ChannelEdits.moveBank(scene, bank, bank(next));
                    case Channel.OfEnvironment _ -> new Change.To(scene);
                }, null);
            }
        } else if (e.isShiftDown()) {
            board.selectTo(strip.channel(), shown.get().stream().map(Strip::channel).toList());
        } else if (e.isShortcutDown()) {
            board.toggle(strip.channel());
        } else {
            board.select(strip.channel());
        }
    }

    private Change drop(Scene scene, String light, Optional<Strip> next) {
        if (next.isPresent() && next.get().channel() instanceof Channel.OfLight(String before)) {
            return ChannelEdits.moveBefore(scene, light, before);
        }
        List<Strip> all = shown.get();
        int at = next.map(all::indexOf).orElse(all.size());
        // Behind the last strip before that is of a light or a bank.
        for (int i = at - 1; i >= 0; i--) {
            switch (all.get(i).channel()) {
                case Channel.OfLight(String name) -> {
                    return ChannelEdits.moveLast(scene, light, scene.light(name).map(l -> l.bank()).orElse(""));
                }
                case Channel.OfBank(String bank) -> {
                    return ChannelEdits.moveLast(scene, light, bank);
                }
                case Channel.OfEnvironment _ -> {
                    // It stands behind all lights.
                }
            }
        }
        return ChannelEdits.moveLast(scene, light, "");
    }
}
