/* A camera of Video4Linux without a kernel module, to preload (LD_PRELOAD): the calls that OpenCV and the program make on
 * the nodes below $V4L_ROOT/dev reach this file instead.  It keeps to what the kernel's documentation and the driver for USB
 * cameras do: one owner of the buffers over all processes (EBUSY), a wait by select(), stamps of CLOCK_MONOTONIC, ENODEV when
 * the node is gone.  Files of $V4L_ROOT switch faults on: stall (no frame), broken (every fourth JPEG is cut), hang (stopping
 * the stream never returns).  JPEG frames are the file jpeg there. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

enum { FILES = 1024, BUFFERS = 8, RATE_HZ = 30 };

struct camera {
    int open, lock, owner, width, height, buffers, queued, automatic, exposure, gain;
    unsigned format, sequence, queue[BUFFERS];
    void *memory[BUFFERS];
    char path[512];
};
static struct camera cameras[FILES]; /* by file descriptor, which is a timer: readable when the next frame is there */

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static struct camera *camera_of(int fd) { return fd >= 0 && fd < FILES && cameras[fd].open ? &cameras[fd] : NULL; }

static int refuse(int fault) {
    errno = fault;
    return -1;
}

static const char *below_root(char *path, const char *name) {
    const char *root = getenv("V4L_ROOT");
    snprintf(path, 512, "%s/%s", root ? root : "/nowhere", name);
    return path;
}

static int is_on(const char *fault) {
    char path[512];
    return access(below_root(path, fault), F_OK) == 0;
}

static int open_node(const char *path, int flags, int mode) {
    char prefix[512];
    below_root(prefix, "dev/video");
    int file = REAL(open64)(path, flags, mode);
    if (file < 0 || strncmp(path, prefix, strlen(prefix))) return file;
    int fd = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK);
    cameras[fd] = (struct camera){.open = 1, .lock = file, .width = 640, .height = 480, .format = V4L2_PIX_FMT_YUYV, .automatic = 3, .exposure = 157, .gain = 20};
    snprintf(cameras[fd].path, sizeof cameras[fd].path, "%s", path);
    return fd;
}

#define OPEN(name)                                                                                                     \
    int name(const char *path, int flags, ...) {                                                                       \
        va_list rest;                                                                                                  \
        va_start(rest, flags);                                                                                         \
        int mode = va_arg(rest, int);                                                                                  \
        va_end(rest);                                                                                                  \
        return open_node(path, flags, mode);                                                                           \
    }
OPEN(open)
OPEN(open64)

int close(int fd) {
    struct camera *c = camera_of(fd);
    if (c) {
        c->open = 0;
        REAL(close)(c->lock);
    }
    return REAL(close)(fd);
}

#define MAP(name)                                                                                                      \
    void *name(void *address, size_t size, int protection, int flags, int fd, off_t offset) {                          \
        struct camera *c = camera_of(fd);                                                                              \
        if (!c) return REAL(name)(address, size, protection, flags, fd, offset);                                       \
        return c->memory[(offset >> 24) & 7] = REAL(name)(address, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); \
    }
MAP(mmap)
MAP(mmap64)

static size_t frame_size(const struct camera *c) { return (size_t)c->width * c->height * (c->format == V4L2_PIX_FMT_GREY ? 1 : 2); }

static int own(struct camera *c) {
    if (!c->owner && flock(c->lock, LOCK_EX | LOCK_NB)) return refuse(EBUSY);
    c->owner = 1;
    return 0;
}

static int format(struct camera *c, struct v4l2_format *f, int set) {
    if (f->type != V4L2_BUF_TYPE_VIDEO_CAPTURE) return refuse(EINVAL);
    struct v4l2_pix_format *p = &f->fmt.pix;
    if (set) {
        if (c->buffers || own(c)) return refuse(EBUSY);
        unsigned wanted = p->pixelformat; /* what it does not have is replaced, not refused */
        c->format = wanted == V4L2_PIX_FMT_MJPEG || wanted == V4L2_PIX_FMT_GREY ? wanted : V4L2_PIX_FMT_YUYV;
        c->width = p->width <= 400 ? 320 : 640;
        c->height = c->width * 3 / 4;
    }
    p->width = c->width, p->height = c->height, p->pixelformat = c->format, p->field = V4L2_FIELD_NONE;
    p->bytesperline = c->format == V4L2_PIX_FMT_MJPEG ? 0 : frame_size(c) / c->height;
    p->sizeimage = frame_size(c);
    return 0;
}

static size_t expose(struct camera *c, unsigned char *pixels) {
    size_t size = frame_size(c);
    if (c->format == V4L2_PIX_FMT_MJPEG) {
        char path[512];
        int file = REAL(open64)(below_root(path, "jpeg"), O_RDONLY);
        ssize_t got = read(file, pixels, size);
        REAL(close)(file);
        return is_on("broken") && c->sequence % 4 == 0 ? 100 : (size_t)got;
    }
    memset(pixels, 126, size); /* Y = 126: 128 when the range of video is stretched */
    for (size_t i = 1; c->format == V4L2_PIX_FMT_YUYV && i < size; i += 2) pixels[i] = 128; /* no colour */
    return size;
}

static int dequeue(struct camera *c, int fd, struct v4l2_buffer *b) {
    unsigned long long periods;
    if (read(fd, &periods, sizeof periods) != sizeof periods || is_on("stall") || !c->queued) return refuse(EAGAIN);
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    b->index = c->queue[0];
    memmove(c->queue, c->queue + 1, --c->queued * sizeof c->queue[0]);
    b->timestamp = (struct timeval){now.tv_sec, now.tv_nsec / 1000};
    b->flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
    b->sequence = c->sequence++;
    b->length = frame_size(c);
    b->bytesused = expose(c, c->memory[b->index]);
    return 0;
}

static int stream(int fd, int on) {
    struct itimerspec period = {{0, on ? 1000000000 / RATE_HZ : 0}, {0, on ? 1000000000 / RATE_HZ : 0}};
    if (!on && is_on("hang")) sleep(3600);
    return timerfd_settime(fd, 0, &period, NULL);
}

static int control(struct camera *c, unsigned id, int **value, int *least, int *most) {
    *least = 0;
    if (id == V4L2_CID_EXPOSURE_AUTO) return *value = &c->automatic, *most = 3, 0;
    if (id == V4L2_CID_EXPOSURE_ABSOLUTE) return *value = &c->exposure, *least = 3, *most = 2047, 0;
    if (id == V4L2_CID_GAIN) return *value = &c->gain, *most = 100, 0;
    return refuse(EINVAL);
}

int ioctl(int fd, unsigned long request, ...) {
    va_list rest;
    va_start(rest, request);
    void *about = va_arg(rest, void *);
    va_end(rest);
    struct camera *c = camera_of(fd);
    if (!c) return REAL(ioctl)(fd, request, about);
    if (access(c->path, F_OK)) return refuse(ENODEV);
    int *value, least, most;
    switch ((unsigned)request) {
    case (unsigned)VIDIOC_QUERYCAP: {
        struct v4l2_capability *is = about;
        *is = (struct v4l2_capability){.driver = "uvcvideo", .card = "model", .device_caps = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING};
        is->capabilities = is->device_caps | V4L2_CAP_DEVICE_CAPS;
        return 0;
    }
    case (unsigned)VIDIOC_ENUMINPUT: return ((struct v4l2_input *)about)->index ? refuse(EINVAL) : 0;
    case (unsigned)VIDIOC_G_INPUT: return *(int *)about = 0;
    case (unsigned)VIDIOC_S_INPUT: return 0;
    case (unsigned)VIDIOC_G_FMT: return format(c, about, 0);
    case (unsigned)VIDIOC_S_FMT: return format(c, about, 1);
    case (unsigned)VIDIOC_G_PARM:
    case (unsigned)VIDIOC_S_PARM:
        ((struct v4l2_streamparm *)about)->parm.capture.timeperframe = (struct v4l2_fract){1, RATE_HZ};
        return 0;
    case (unsigned)VIDIOC_REQBUFS: {
        struct v4l2_requestbuffers *r = about;
        if (own(c)) return -1;
        c->buffers = r->count = r->count < BUFFERS ? r->count : BUFFERS;
        c->queued = 0;
        if (!c->buffers) c->owner = flock(c->lock, LOCK_UN);
        return 0;
    }
    case (unsigned)VIDIOC_QUERYBUF: {
        struct v4l2_buffer *b = about;
        b->length = frame_size(c), b->m.offset = b->index << 24;
        return (int)b->index < c->buffers ? 0 : refuse(EINVAL);
    }
    case (unsigned)VIDIOC_QBUF: c->queue[c->queued++] = ((struct v4l2_buffer *)about)->index; return 0;
    case (unsigned)VIDIOC_DQBUF: return dequeue(c, fd, about);
    case (unsigned)VIDIOC_STREAMON: return stream(fd, 1);
    case (unsigned)VIDIOC_STREAMOFF: c->queued = 0; return stream(fd, 0);
    case (unsigned)VIDIOC_QUERYCTRL: {
        struct v4l2_queryctrl *q = about;
        return control(c, q->id, &value, &q->minimum, &q->maximum);
    }
    case (unsigned)VIDIOC_G_CTRL:
    case (unsigned)VIDIOC_S_CTRL: {
        struct v4l2_control *x = about;
        if (control(c, x->id, &value, &least, &most)) return -1;
        if ((unsigned)request == (unsigned)VIDIOC_S_CTRL) *value = x->value < least ? least : x->value > most ? most : x->value;
        x->value = *value;
        return 0;
    }
    }
    return refuse(ENOTTY);
}
