package lightning.editor.window.model;

import javafx.beans.property.LongProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleLongProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.editor.document.Workbench;
import lightning.editor.loop.Frame;
import lightning.editor.loop.RenderState;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/** The traced picture: its pixels, the progress of the next one, and how linear light becomes display pixels. */
public final class TracedPicture {
    private final ReadOnlyObjectWrapper<RenderState> renderState = new ReadOnlyObjectWrapper<>(RenderState.NONE);
    private final LongProperty repaints = new SimpleLongProperty();
    private final ObjectProperty<ViewTransform> view = new SimpleObjectProperty<>();
    private final Workbench workbench;
    private final TracedRaster raster;

    /** @param raster receives what the workbench renders */
    TracedPicture(Workbench workbench, TracedRaster raster) {
        this.workbench = workbench;
        this.raster = raster;
        view.set(raster.view());
        workbench.setView(view.get());
        view.addListener((_, _, now) -> {
            workbench.setView(now);
            raster.setView(now);
            repaint();
        });
    }

    /** The last picture, and the progress of the next one. */
    public ReadOnlyObjectProperty<RenderState> renderStateProperty() {
        return renderState.getReadOnlyProperty();
    }

    /** The last picture; null before the first. */
    public Frame frame() {
        return renderState.get().frame();
    }

    /** How linear light becomes display pixels. */
    public ObjectProperty<ViewTransform> viewProperty() {
        return view;
    }

    public TracedRaster raster() {
        return raster;
    }

    /** Changes whenever the raster may have. */
    public LongProperty repaintsProperty() {
        return repaints;
    }

    /** Reports a change of the raster. */
    public void repaint() {
        repaints.set(repaints.get() + 1);
    }

    /** Shows a film of the scene that is being rendered, made by another machine, until its own picture is there. */
    public void showRemote(Film film, Scene scene) {
        raster.showRemote(film, scene);
        repaint();
    }

    /** Shows what the workbench renders now, where that is another picture or further. */
    void refresh() {
        if (renderState.get() != workbench.renderState()) {
            update();
        }
    }

    /** Shows what the workbench renders now; the raster may have changed without it. */
    void update() {
        renderState.set(workbench.renderState());
        repaint();
    }
}
