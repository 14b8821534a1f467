package lightning.serve;

import lightning.format.json.ExplainReport;
import lightning.format.json.PixelReporter;
import lightning.format.json.ReportMapper;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.fog.PictureFog;
import lightning.scene.Scene;
import tools.jackson.databind.node.ObjectNode;

/** Request {@code explain}: updates the picture and reports how the color of one pixel is computed. */
final class PixelRequest {
    private final SceneSession session;
    private final Request request;
    private final Scene scene;
    private final int x;
    private final int y;

    PixelRequest(SceneSession session, Request request) {
        this.session = session;
        this.request = request;
        scene = session.scene();
        request.fields().flag("progress");
        int[] pixel = request.fields().integers("pixel", 2, 0, Integer.MAX_VALUE);
        x = pixel[0];
        y = pixel[1];
        if (x >= scene.picture().width() || y >= scene.picture().height()) {
            throw Fields.bad("pixel", "expected a pixel inside the picture, from 0, 0 to " + (scene.picture().width() - 1) + ", "
                    + (scene.picture().height() - 1));
        }
    }

    ObjectNode run() {
        session.update(request, 0);
        Renderer renderer = session.renderer();
        var indirect = renderer.cache().indirect();
        PictureFog bounceFog = renderer.cache().hasCurrentReflections() ? renderer.cache().mirrored().fog() : null;
        PixelExplainer explainer = new PixelExplainer(renderer.scene(), renderer.cache().geometry())
                .withIndirect(indirect == null ? null : indirect.light()).withFog(renderer.cache().shown().fog(), bounceFog)
                .withPassedCutouts();
        Film film = renderer.film();
        ExplainReport report = new PixelReporter(scene, explainer).report(x, y, explainer.explainPixel(x, y),
                new float[] {film.red(x, y), film.green(x, y), film.blue(x, y)});
        return ReportMapper.MAPPER.valueToTree(report);
    }
}
