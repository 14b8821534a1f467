package lightning.format.nff;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Notes;
import lightning.format.mesh.PartNames;
import lightning.format.mesh.Polygon;
import lightning.format.mesh.TextSource;
import lightning.scene.Mesh;

/**
 * Reads NFF files: {@code v b l f c s p pp} and comments. What other dialects have beside these is passed over, line by line, and
 * told.
 */
public final class NffReader {
    /** Spheres, cones and cylinders: as many as a scene may have shapes. */
    private static final int MOST_SOLIDS = 1_000_000;
    private static final int MOST_FILLS = 30_000;
    private static final int MOST_LIGHTS = 1000;

    private final ByteSource source;
    private final TextSource text;
    private final Notes notes;
    private final NffView view = new NffView();
    private final List<NffFile.Light> lights = new ArrayList<>();
    private final Map<NffFile.Fill, Integer> fills = new LinkedHashMap<>();
    private final List<NffSolid> solids = new ArrayList<>();
    /** By fill: polygons at twice its number, patches behind. */
    private final Map<Integer, SurfaceMaker> surfaces = new LinkedHashMap<>();
    private final Polygon polygon = new Polygon();
    private Rgb background = Rgb.BLACK;
    private int fill = -1;
    /** What stands next, in messages. */
    private String expected = "";
    private long vertices;
    private long triangles;

    private NffReader(ByteSource source, Notes notes) {
        this.source = source;
        this.notes = notes;
        text = new TextSource(source);
    }

    /**
     * Reads a whole file.
     *
     * @param notes hears what is left out
     * @throws MeshException if it is damaged, or holds no shape
     * @throws IOException   if it cannot be read
     */
    public static NffFile read(ByteSource source, Notes notes) throws IOException, MeshException {
        return new NffReader(source, notes).read();
    }

    private NffFile read() throws IOException, MeshException {
        do {
            while (text.word() && text.at(0) != '#') {
                entity();
            }
        } while (text.nextLine());
        if (solids.isEmpty() && triangles == 0) {
            throw source.problem("", "must have shapes (c, s, p or pp): without them there is nothing to light");
        }
        return new NffFile(view.made(), background, List.copyOf(lights), List.copyOf(fills.keySet()), List.copyOf(solids), surfaces());
    }

    private void entity() throws IOException, MeshException {
        String keyword = text.length() <= 16 ? text.text() : Quote.of(text.text());
        expected = "a number of " + keyword;
        switch (keyword) {
            // All that follows it has a word of its own.
            case "v" -> {}
            case "from" -> view.from = point();
            case "at" -> view.at = point();
            case "up" -> view.up = point();
            case "angle" -> view.angle = number();
            case "hither", "yon" -> number();
            case "resolution" -> {
                view.width = whole();
                view.height = whole();
            }
            case "b" -> background = color();
            case "l" -> light();
            case "f" -> fill();
            case "s" -> ball();
            case "c" -> tube();
            case "p" -> polygon(false);
            case "pp" -> polygon(true);
            default -> {
                notes.add("entities " + keyword);
                text.rest();
            }
        }
    }

    private void light() throws IOException, MeshException {
        if (lights.size() == MOST_LIGHTS) {
            throw text.problem("a file must have at most " + MOST_LIGHTS + " lights");
        }
        Vec3 at = point();
        Optional<Rgb> color = Optional.empty();
        if (isNumberLeft()) {
            color = Optional.of(color(text.number(expected)));
            text.word();
        }
        lights.add(new NffFile.Light(at, color));
        passLine("words behind lights, of another dialect");
    }

    /** The colour must be there; what else is missing on the line is taken as a dull surface has it. */
    private void fill() throws IOException, MeshException {
        Rgb color = color();
        double[] rest = {1, 0, 1, 0, 1};
        int count = 0;
        while (count < rest.length && isNumberLeft()) {
            rest[count++] = text.number(expected);
        }
        if (count == rest.length) {
            text.word();
        } else {
            notes.add("fills with fewer than eight numbers");
        }
        passLine("words behind fills, of another dialect");
        fill = fills.computeIfAbsent(new NffFile.Fill(color, rest[0], rest[1], rest[2], rest[3], rest[4]), _ -> fills.size());
        if (fills.size() > MOST_FILLS) {
            throw text.problem("a file must have at most " + MOST_FILLS + " different fills");
        }
    }

    private void ball() throws IOException, MeshException {
        Vec3 center = point();
        add(new NffSolid.Ball(fill, center, Math.abs(outside(number()))));
    }

    private void tube() throws IOException, MeshException {
        Vec3 base = point();
        double baseRadius = number();
        Vec3 apex = point();
        double apexRadius = number();
        outside(Math.min(baseRadius, apexRadius));
        add(new NffSolid.Tube(fill, base, Math.abs(baseRadius), apex, Math.abs(apexRadius)));
    }

    /** Of what has a negative radius, only the inside is seen; here all is seen from both sides. */
    private double outside(double radius) {
        notes.add("shapes of which only the inside is to be seen", radius < 0 ? 1 : 0);
        return radius;
    }

    private void add(NffSolid solid) throws MeshException {
        if (solids.size() == MOST_SOLIDS) {
            throw text.problem("a file must have at most " + MOST_SOLIDS + " spheres, cones and cylinders");
        }
        solids.add(solid);
    }

    private void polygon(boolean smooth) throws IOException, MeshException {
        int count = whole();
        SurfaceMaker to = surfaces.computeIfAbsent(2 * fill + (smooth ? 1 : 0), _ -> new SurfaceMaker(fill, smooth));
        int before = to.vertexCount();
        to.begin();
        for (int i = 0; i < count; i++) {
            Vec3 p = point();
            Vec3 n = smooth ? direction() : Vec3.ZERO;
            to.corner((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z());
        }
        vertices += to.vertexCount() - before;
        if (count < 3) {
            notes.add("polygons of fewer than three corners");
            return;
        }
        notes.add("outlines of polygons with more than " + Polygon.MOST_CORNERS + " corners, which are cut as if they were convex",
                count > Polygon.MOST_CORNERS ? 1 : 0);
        triangles += count - 2;
        if (vertices > MeshLimits.VERTICES || triangles > MeshLimits.TRIANGLES) {
            throw text.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles and " + MeshLimits.VERTICES + " vertices");
        }
        to.end(polygon);
    }

    private List<NffFile.Surface> surfaces() throws MeshException {
        var names = new PartNames();
        List<NffFile.Surface> meshes = new ArrayList<>();
        for (SurfaceMaker made : surfaces.values()) {
            if (made.triangleCount() > 0) {
                meshes.add(new NffFile.Surface(made.fill, names.unique(made.isSmooth() ? "patches" : "polygons", "mesh"), made.mesh()));
            }
        }
        return List.copyOf(meshes);
    }

    /** Passes over the rest of a line from the word that was read last on, and tells it unless it is a comment. */
    private void passLine(String kind) throws IOException, MeshException {
        notes.add(kind, text.length() > 0 && text.at(0) != '#' ? 1 : 0);
        text.rest();
    }

    /** The next word, on this line or one that follows. */
    private void word() throws IOException, MeshException {
        while (!text.word() || text.at(0) == '#') {
            if (!text.nextLine()) {
                throw text.problem("expected " + expected + ", found the end of the file");
            }
        }
    }

    /** Reads the next word of this line; whether it looks like a number. */
    private boolean isNumberLeft() throws IOException, MeshException {
        return text.word() && (text.at(0) >= '0' && text.at(0) <= '9' || text.at(0) == '-' || text.at(0) == '+' || text.at(0) == '.');
    }

    private double number() throws IOException, MeshException {
        word();
        return text.number(expected);
    }

    private int whole() throws IOException, MeshException {
        word();
        return (int) text.whole(expected, 0, Integer.MAX_VALUE);
    }

    private Vec3 direction() throws IOException, MeshException {
        return new Vec3(number(), number(), number());
    }

    private Vec3 point() throws IOException, MeshException {
        Vec3 p = direction();
        if (p.maxAbs() > Mesh.MAX_COORDINATE) {
            throw text.problem("a coordinate must be at most " + Decimal.text(Mesh.MAX_COORDINATE) + " in absolute value, was "
                    + Decimal.text(p.maxAbs()));
        }
        return p;
    }

    private Rgb color() throws IOException, MeshException {
        return color(number());
    }

    private Rgb color(double red) throws IOException, MeshException {
        return new Rgb(red, number(), number());
    }
}
